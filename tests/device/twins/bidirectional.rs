//! Twins of those functions of `shaders/integrator/bidirectional/` that need no scene: weights, and which vertices are kept.

use vkpt::prepared::MaterialKind;
use vkpt::reference::integrator::bidirectional::partial::{
    Junction, Partial, arrive, bounded, earlier, from_eye, from_light_point, hit_weight, hypot,
    light_weight, scatter, scatter_delta, splat_weight, vertex_weight, weight,
};
use vkpt::reference::integrator::bidirectional::reservoir::{has_density, kept_place, kept_share};

use super::harness::{In, Out, Rng, Row, Twin};

const PARTIAL: &str = "integrator/bidirectional/partial";

pub fn twins() -> Vec<Twin> {
    vec![sums(), starts(), steps(), ways(), joined(), kept(), lobes()]
}

/// Ratios and densities: 0, from next to nothing to far more than the bound, infinite.
fn number(r: &mut Rng) -> f32 {
    match r.below(12) {
        0 => 0.0,
        1 => f32::INFINITY,
        2 => r.log_range(1e-38, 1e38),
        _ => r.log_range(1e-6, 1e6),
    }
}

fn numbers(count: usize) -> impl Fn(&mut Rng) -> Row {
    move |r| (0..count).fold(Row::new(), |row, _| row.f(number(r)))
}

fn partial(i: &mut In) -> Partial<f32> {
    Partial {
        vcm: i.f(),
        vc: i.f(),
    }
}

fn junction(i: &mut In) -> Junction<f32> {
    Junction {
        cosine: i.f(),
        pdf: i.f(),
        reverse_pdf: i.f(),
    }
}

fn out(p: Partial<f32>, o: &mut Out) {
    o.f(p.vcm);
    o.f(p.vc);
}

const READ: &str = "Partial p; p.vcm = in_f(); p.vc = in_f();";
const JOIN: &str = "Junction x; x.cosine = in_f(); x.pdf = in_f(); x.reverse_pdf = in_f();";

fn sums() -> Twin {
    Twin::new("hypot", PARTIAL)
        .also(&["bounded", "weight"])
        .glsl("float a = in_f(); float b = in_f(); out_f(hypot(a, b)); out_f(bounded(a)); out_f(weight(a, b));")
        .rust(|i, o| {
            let (a, b) = (i.f(), i.f());
            o.f(hypot(a, b));
            o.f(bounded(a));
            o.f(weight(a, b));
        })
        .edge([0.0, 0.0])
        .edge([1e18, 1e18])
        .seeded(2000, numbers(2))
}

fn starts() -> Twin {
    Twin::new("from_light_point", PARTIAL)
        .also(&["from_eye"])
        .glsl(
            "float p_n = in_f(); float emission = in_f(); float cosine = in_f();
             Partial l = from_light_point(p_n, emission, cosine); out_f(l.vcm); out_f(l.vc);
             Partial e = from_eye(emission, cosine); out_f(e.vcm); out_f(e.vc);",
        )
        .rust(|i, o| {
            let (p_n, emission, cosine) = (i.f(), i.f(), i.f());
            out(from_light_point(p_n, emission, cosine), o);
            out(from_eye(emission, cosine), o);
        })
        .seeded(2000, numbers(3))
}

fn steps() -> Twin {
    Twin::new("arrive", PARTIAL)
        .also(&["scatter", "scatter_delta", "earlier"])
        .glsl(&format!(
            "{READ} {JOIN} Partial a = arrive(p, x.pdf, x.cosine); out_f(a.vcm); out_f(a.vc);
             Partial s = scatter(p, x); out_f(s.vcm); out_f(s.vc);
             Partial d = scatter_delta(p, x.cosine); out_f(d.vcm); out_f(d.vc);
             out_f(earlier(p, x.reverse_pdf));"
        ))
        .rust(|i, o| {
            let (p, x) = (partial(i), junction(i));
            out(arrive(p, x.pdf, x.cosine), o);
            out(scatter(p, x), o);
            out(scatter_delta(p, x.cosine), o);
            o.f(earlier(p, x.reverse_pdf));
        })
        .seeded(4000, numbers(5))
}

fn ways() -> Twin {
    Twin::new("light_weight", PARTIAL)
        .also(&["hit_weight", "splat_weight"])
        .glsl(&format!(
            "{READ} {JOIN} float p_n = in_f(); float emission = in_f();
             out_f(hit_weight(p, p_n, emission)); out_f(light_weight(p, x, p_n, emission));
             out_f(splat_weight(p, x, emission));"
        ))
        .rust(|i, o| {
            let (p, x, p_n, emission) = (partial(i), junction(i), i.f(), i.f());
            o.f(hit_weight(p, p_n, emission));
            o.f(light_weight(p, x, p_n, emission));
            o.f(splat_weight(p, x, emission));
        })
        .seeded(4000, numbers(7))
}

fn joined() -> Twin {
    let other = [READ, JOIN]
        .concat()
        .replace("p.", "q.")
        .replace("x.", "y.");
    let other = other
        .replace("Partial p", "Partial q")
        .replace("Junction x", "Junction y");
    Twin::new("vertex_weight", PARTIAL)
        .glsl(&format!(
            "{READ} {JOIN} {other} out_f(vertex_weight(p, x, q, y, in_f()));"
        ))
        .rust(|i, o| {
            let (p, x, q, y) = (partial(i), junction(i), partial(i), junction(i));
            o.f(vertex_weight(p, x, q, y, i.f()));
        })
        .seeded(4000, numbers(11))
}

fn kept() -> Twin {
    Twin::new("kept_place", "integrator/bidirectional/reservoir")
        .also(&["kept_share"])
        .glsl("uint seen = in_u(); out_f(kept_share(seen)); out_u(kept_place(seen, in_f()));")
        .rust(|i, o| {
            let seen = i.u();
            o.f(kept_share(seen));
            o.u(kept_place(seen, i.f()));
        })
        .seeded(500, |r| Row::new().u(r.below(40)).f(r.unit()))
}

fn lobes() -> Twin {
    Twin::new("has_density", "integrator/bidirectional/reservoir")
        .glsl("uint kind = in_u(); out_b(has_density(kind, in_vec3()));")
        .rust(|i, o| {
            let kind = MaterialKind::EVERY[i.u() as usize];
            o.b(has_density(kind, i.vec3()));
        })
        .seeded(200, |r| {
            let kd = [0.0, 0.3][r.below(2) as usize];
            let row = Row::new().u(r.below(MaterialKind::EVERY.len() as u32));
            row.f(0.0).f(kd).f(0.0)
        })
}
