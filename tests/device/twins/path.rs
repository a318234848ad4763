//! Twins of those functions of `shaders/path/` that need no scene: weights, Beer's law, roulette, signatures.

use vkpt::prepared::MaterialKind;
use vkpt::reference::bsdf::{LOBE_DELTA, LOBE_REFLECTION, LOBE_TRANSMISSION};
use vkpt::reference::integrator::path::connect::{connection_weight, hit_weight, power_heuristic};
use vkpt::reference::integrator::path::signature::{decide, is_light, path_signature};
use vkpt::reference::math::normalize3;
use vkpt::reference::path::medium::{beer, beer3};
use vkpt::reference::path::roulette::roulette_survival;
use vkpt::reference::path::throughput::{channel_shares, underflows};
use vkpt::reference::path::valid::{leaving_direction, seen_normal};
use vkpt::settings::{Connect, Roulette};

use super::harness::{Rng, Row, Twin};

pub fn twins() -> Vec<Twin> {
    let mut twins = vec![
        heuristic(),
        absorption(),
        absorption_of_colours(),
        underflow(),
        decision(),
        light(),
        signature(),
        valid(),
    ];
    // Where light is found by chance alone, the kernel connects nothing.
    let connects = CONNECT
        .into_iter()
        .filter(|(connect, _)| *connect != Connect::Bsdf);
    twins.extend(connects.map(connection));
    twins.extend(CONNECT.map(hit));
    twins.extend(ROULETTE.map(survival));
    twins
}

const CONNECT: [(Connect, &str); 3] = [
    (Connect::Mis, "integrator/path/connect/mis"),
    (Connect::Light, "integrator/path/connect/light"),
    (Connect::Bsdf, "integrator/path/connect/bsdf"),
];

/// Two densities; from next to nothing to near a delta.
fn densities(r: &mut Rng) -> Row {
    Row::new()
        .f(r.log_range(1e-9, 1e9))
        .f(r.log_range(1e-9, 1e9))
}

/// Neither, one or both 0, far apart, infinite.
const DENSITIES: [[f32; 2]; 8] = [
    [0.0, 0.0],
    [1.0, 0.0],
    [0.0, 1.0],
    [1.0, 1.0],
    [1e-30, 1e30],
    [1e30, 1e-30],
    [f32::INFINITY, 1.0],
    [1.0, f32::INFINITY],
];

/// Normals on one side of a face, from the face's own to one that turns away from wo, and directions on either side of it.
fn valid() -> Twin {
    Twin::new("seen_normal", "path/valid/smooth")
        .also(&["leaving_direction"])
        .glsl(
            "vec3 n = in_vec3(); vec3 g = in_vec3(); vec3 w = in_vec3(); float z = in_f(); uint lobe = in_u();
             out_vec3(seen_normal(n, g, w, in_u()));
             out_vec3(leaving_direction(n, g, w, z, lobe));",
        )
        .rust(|i, o| {
            let (n, g, w, z, lobe) = (i.vec3(), i.vec3(), i.vec3(), i.f(), i.u());
            o.vec3(seen_normal(n, g, w, MaterialKind::EVERY[i.u() as usize]));
            o.vec3(leaving_direction(n, g, w, z, lobe));
        })
        .seeded(4000, |r| {
            let g = r.direction();
            let near = [1.0, 1e-3, 0.0][r.below(3) as usize];
            let n = normalize3(g + r.direction() * near);
            let lobe = [LOBE_REFLECTION, LOBE_TRANSMISSION][r.below(2) as usize];
            let delta = [0, LOBE_DELTA][r.below(2) as usize];
            let row = Row::new().vec3(n).vec3(g).vec3(r.direction());
            row.f([-0.5, 0.5][r.below(2) as usize]).u(lobe | delta).u(r.below(7))
        })
}

fn heuristic() -> Twin {
    Twin::new("power_heuristic", "integrator/path/connect/mis")
        .glsl("float p = in_f(); out_f(power_heuristic(p, in_f()));")
        .rust(|i, o| {
            let p = i.f();
            o.f(power_heuristic(p, i.f()));
        })
        .edges(DENSITIES.map(Row::from))
        .seeded(5000, densities)
}

fn connection((connect, file): (Connect, &'static str)) -> Twin {
    Twin::new("connection_weight", file)
        .glsl("float l = in_f(); out_f(connection_weight(l, in_f()));")
        .rust(move |i, o| {
            let light_pdf = i.f();
            o.f(connection_weight(connect, light_pdf, i.f()));
        })
        .edges(DENSITIES.map(Row::from))
        .seeded(500, densities)
}

fn hit((connect, file): (Connect, &'static str)) -> Twin {
    let row = |delta: u32, [b, l]: [f32; 2]| Row::new().u(delta).f(b).f(l);
    Twin::new("hit_weight", file)
        .glsl("bool delta = in_b(); float b = in_f(); out_f(hit_weight(delta, b, in_f()));")
        .rust(move |i, o| {
            let (delta, bsdf_pdf) = (i.b(), i.f());
            o.f(hit_weight(connect, delta, bsdf_pdf, i.f()));
        })
        .edges(DENSITIES.iter().flat_map(|p| [row(0, *p), row(1, *p)]))
        .seeded(500, move |r| {
            row(r.below(2), [r.log_range(1e-9, 1e9), r.log_range(1e-9, 1e9)])
        })
}

/// Nothing, the least, the most that a scene has (σ = 1e30 where Kt = 0), at distance 0 and far away.
const SIGMA_T: [[f32; 2]; 8] = [
    [0.0, 0.0],
    [0.0, 1e30],
    [1e30, 0.0],
    [1e30, 1e-30],
    [1e30, 1e-45],
    [1e-45, 1.0],
    [0.693, 1.0],
    [1e30, 1e30],
];

fn absorption() -> Twin {
    Twin::new("beer", "path/medium/beer")
        .glsl("float sigma = in_f(); out_f(beer(sigma, in_f()));")
        .rust(|i, o| {
            let sigma = i.f();
            o.f(beer(sigma, i.f()));
        })
        .edges(SIGMA_T.map(Row::from))
        .seeded(5000, |r| {
            Row::new()
                .f(r.log_range(1e-5, 1e3))
                .f(r.log_range(1e-4, 1e2))
        })
}

fn absorption_of_colours() -> Twin {
    Twin::new("beer3", "path/medium/beer")
        .glsl("vec3 sigma = in_vec3(); out_vec3(beer3(sigma, in_f()));")
        .rust(|i, o| {
            let sigma = i.vec3();
            o.vec3(beer3(sigma, i.f()));
        })
        .edge([0.0, 0.5, 1e30, 2.0])
        .seeded(500, |r| {
            Row::new().vec3(r.vec3(0.0, 5.0)).f(r.log_range(1e-4, 1e2))
        })
}

const ROULETTE: [(Roulette, &str); 3] = [
    (Roulette::Throughput, "path/roulette/throughput"),
    (Roulette::Constant(0.8), "path/roulette/constant"),
    (Roulette::Off, "path/roulette/off"),
];

fn survival((roulette, file): (Roulette, &'static str)) -> Twin {
    let constant = match roulette {
        Roulette::Constant(p) => format!("const float ROULETTE = {:?};\n", p as f32),
        _ => String::new(),
    };
    let row = |throughput: f32, eta_scale: f32, bounce: u32| {
        Row::new()
            .f(throughput)
            .f(0.5 * throughput)
            .f(0.25)
            .f(eta_scale)
            .u(bounce)
    };
    let bounces = [0, 1, 2, 3, 999, 1000, 1001, u32::MAX];
    let lossless = move |bounce| {
        [
            row(1.0, 1.0, bounce),
            row(1.0 / 2.25, 1.0 / 2.25, bounce),
            row(0.9, 1.0, bounce),
        ]
    };
    Twin::new("roulette_survival", file)
        .also(&["long_path_survival"])
        .prelude(constant)
        .glsl("vec3 throughput = in_vec3(); float eta_scale = in_f(); out_f(roulette_survival(throughput, eta_scale, in_u()));")
        .rust(move |i, o| {
            let (throughput, eta_scale) = (i.vec3(), i.f());
            o.f(roulette_survival(roulette, throughput, eta_scale, i.u()));
        })
        .edges(bounces.into_iter().flat_map(lossless))
        .edge(row(0.0, 1.0, 5))
        .edge(row(f32::NAN, 1.0, 5))
        .seeded(2000, move |r| row(r.log_range(1e-6, 4.0), r.log_range(0.1, 10.0), r.below(1100)))
}

fn underflow() -> Twin {
    let row = |t: [f32; 3], w: [f32; 3]| [t, w].concat().into_iter().fold(Row::new(), Row::f);
    Twin::new("underflows", "path/throughput")
        .also(&["channel_shares"])
        .glsl("vec3 t = in_vec3(); out_vec3(channel_shares(t)); out_b(underflows(t, in_vec3()));")
        .rust(|i, o| {
            let t = i.vec3();
            o.vec3(channel_shares(t));
            o.b(underflows(t, i.vec3()));
        })
        .edges([
            row([f32::MIN_POSITIVE; 3], [1.0; 3]),
            row([f32::MIN_POSITIVE; 3], [0.9; 3]),
            row([1.0, 0.0, 0.0], [0.0, 1.0, 1.0]),
            row([1e-20, 0.0, 1.0], [1e-20, 1.0, 0.0]),
            row([0.0; 3], [1.0; 3]),
            row([f32::NAN, 1e-30, 1e-30], [1e-30; 3]),
            row([f32::MAX; 3], [2.0; 3]),
        ])
        .seeded(2000, |r| {
            let mut six = || r.log_range(1e-30, 1.0);
            row([six(), six(), six()], [six(), six(), six()])
        })
}

fn decision() -> Twin {
    Twin::new("decide", "integrator/path/signature")
        .glsl("uint chain = in_u(); bool matters = in_b(); uint decision = in_u(); out_u(decide(chain, matters, decision, in_u()));")
        .rust(|i, o| {
            let (chain, matters, decision) = (i.u(), i.b(), i.u());
            o.u(decide(chain, matters, decision, i.u()));
        })
        .edge([0, 1, 1, 0])
        .edge([7, 0, 1, 0])
        .edge([u32::MAX; 4])
        .seeded(500, |r| {
            Row::new()
                .u(r.u32())
                .u(r.below(2))
                .u(1 + r.below(5))
                .u(r.below(100))
        })
}

fn signature() -> Twin {
    Twin::new("path_signature", "integrator/path/signature")
        .glsl("uint vertices = in_u(); out_u(path_signature(vertices, in_u()));")
        .rust(|i, o| {
            let vertices = i.u();
            o.u(path_signature(vertices, i.u()));
        })
        .edge([0, 0])
        .seeded(500, |r| Row::new().u(r.u32()).u(r.u32()))
}

fn light() -> Twin {
    let dark = 2f32.powi(-64);
    Twin::new("is_light", "integrator/path/signature")
        .glsl("out_b(is_light(in_vec3()));")
        .rust(|i, o| {
            let radiance = i.vec3();
            o.b(is_light(radiance));
        })
        .edge([0.0, 0.0, 0.0])
        .edge([0.0, dark, 0.0])
        .edge([0.0, f32::from_bits(dark.to_bits() + 1), 0.0])
        .edge([0.0, 1e-45, f32::INFINITY])
        .edge([f32::NAN, 1.0, 0.0])
        .edge([0.0, 0.0, f32::NAN])
        .seeded(500, |r| {
            Row::new()
                .f(r.log_range(1e-25, 1e-15))
                .f(r.log_range(1e-25, 1e-15))
                .f(0.0)
        })
}
