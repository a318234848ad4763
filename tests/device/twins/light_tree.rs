//! Twins of `shaders/light/tree/`.

use vkpt::layout::GpuStruct;
use vkpt::prepared::device;
use vkpt::reference::light::tree::descent::first_child_share;
use vkpt::reference::light::tree::importance::{cos_beyond, sin_beyond, sine_of};
use vkpt::reference::light::tree::tickets::{first_share, refilled};
use vkpt::reference::light::tree::{
    LightNode, Tickets, all_tickets, node_importance, tree_choice, tree_pmf,
};

use super::harness::{In, Out, Rng, Row, Twin};

pub fn twins() -> Vec<Twin> {
    let mut all = vec![angles(), importance(), share()];
    all.extend(tickets());
    all.extend([descent(), first_shares()]);
    all
}

/// Cosine and sine of an angle of [0, π], at its ends too.
fn angle(r: &mut Rng) -> [f32; 2] {
    let a = f64::from([0.0, 1.0, 0.5, r.unit(), r.unit() * 1e-3][r.below(5) as usize]);
    let (sin, cos) = (a * std::f64::consts::PI).sin_cos();
    [cos as f32, (sin as f32).max(0.0)]
}

fn angles() -> Twin {
    Twin::new("cos_beyond", "light/tree/importance")
        .also(&["sin_beyond", "sine_of"])
        .prelude(nodes())
        .glsl(
            "float ca = in_f(); float sa = in_f(); float cb = in_f(); float sb = in_f();
             out_f(cos_beyond(ca, sa, cb, sb)); out_f(sin_beyond(ca, sa, cb, sb)); out_f(sine_of(ca));",
        )
        .rust(|i, o| {
            let [ca, sa, cb, sb] = [(); 4].map(|()| i.f());
            o.f(cos_beyond(ca, sa, cb, sb));
            o.f(sin_beyond(ca, sa, cb, sb));
            o.f(sine_of(ca));
        })
        .seeded(1000, |r| {
            let ([ca, sa], [cb, sb]) = (angle(r), angle(r));
            Row::from([ca, sa, cb, sb])
        })
}

/// Three nodes over four leaves, each behind the other's first.
const SHAPE: [[u32; 2]; 7] = [[4, 0], [3, 0], [0, 1], [1, 1], [6, 0], [2, 1], [3, 1]];
const TRAILS: [u32; 4] = [0b00, 0b10, 0b01, 0b11];

fn nodes() -> String {
    device::LightNode::glsl() + "LightNode light_nodes[7]; uint light_trails[4];\n"
}

const READ_NODE: &str = "LightNode x; x.centre = in_vec3(); x.radius = in_f(); x.axis = in_vec3();
    x.cos_o = in_f(); x.sin_o = in_f(); x.power = in_f(); x.child = in_u(); x.leaf = in_u();";

fn fill() -> String {
    let trails: String = (0..4)
        .map(|i| format!("light_trails[{i}] = {}u;", TRAILS[i]))
        .collect();
    format!("uint k = 0u; while (k < 7u) {{ {READ_NODE} light_nodes[k] = x; k += 1u; }} {trails}")
}

fn read_node(i: &mut In) -> LightNode<f32> {
    LightNode {
        centre: i.vec3(),
        radius: i.f(),
        axis: i.vec3(),
        cos_o: i.f(),
        sin_o: i.f(),
        power: i.f(),
        child: i.u(),
        leaf: i.u(),
    }
}

/// A node of any size, one in eight without power, one in four of every normal.
fn node(row: Row, r: &mut Rng, [child, leaf]: [u32; 2]) -> Row {
    let power = if r.below(8) == 0 {
        0.0
    } else {
        r.log_range(1e-15, 1.0)
    };
    let [cos, sin] = [[0.0, 1.0], [1.0, 0.0], [0.6, 0.8], [0.8, 0.6]][r.below(4) as usize];
    let row = row
        .vec3(r.vec3(-1.0, 1.0))
        .f(r.log_range(1e-15, 2.0))
        .vec3(r.direction());
    row.f(cos).f(sin).f(power).u(child).u(leaf)
}

/// A point, sometimes far away, and a normal or none.
fn place(row: Row, r: &mut Rng) -> Row {
    let n = r.direction() * [0.0, 1.0][r.below(2) as usize];
    row.vec3(r.vec3(-1.0, 1.0) * [1.0, 100.0][r.below(2) as usize])
        .vec3(n)
}

fn importance() -> Twin {
    Twin::new("node_importance", "light/tree/importance")
        .prelude(nodes())
        .glsl(&format!(
            "{READ_NODE} vec3 p = in_vec3(); out_f(node_importance(x, p, in_vec3()));"
        ))
        .rust(|i, o| {
            let x = read_node(i);
            let p = i.vec3();
            o.f(node_importance(&x, p, i.vec3()));
        })
        .seeded(4000, |r| {
            let row = node(Row::new(), r, [0, 1]);
            place(row, r)
        })
}

const READ_TICKETS: &str =
    "Tickets t; t.drawn = in_u(); t.count = in_u(); t.spare = in_u(); t.spares = in_u();";
const OUT_TICKETS: &str = "out_u(t.drawn); out_u(t.count); out_u(t.spare); out_u(t.spares);";

fn out_tickets(t: Tickets, o: &mut Out) {
    [t.drawn, t.count, t.spare, t.spares]
        .into_iter()
        .for_each(|x| o.u(x));
}

fn tickets() -> Vec<Twin> {
    vec![
        Twin::new("all_tickets", "light/tree/tickets")
            .glsl(&format!(
                "uint a = in_u(); uint b = in_u(); uint c = in_u(); Tickets t = all_tickets(uvec4(a, b, c, in_u())); {OUT_TICKETS}"
            ))
            .rust(|i, o| out_tickets(all_tickets([(); 4].map(|()| i.u())), o))
            .seeded(200, |r| (0..4).fold(Row::new(), |row, _| row.u(r.u32()))),
        Twin::new("refilled", "light/tree/tickets")
            .glsl(&format!("{READ_TICKETS} t = refilled(t); {OUT_TICKETS}"))
            .rust(|i, o| {
                let [drawn, count, spare, spares] = [(); 4].map(|()| i.u());
                out_tickets(refilled(Tickets { drawn, count, spare, spares }), o);
            })
            .seeded(500, |r| {
                let count = (1 << r.below(32)) + r.below(2);
                Row::new().u(r.below(count)).u(count).u(r.below(1 << 24)).u(r.below(4))
            }),
    ]
}

fn share() -> Twin {
    Twin::new("first_share", "light/tree/tickets")
        .glsl("uint count = in_u(); float a = in_f(); out_u(first_share(count, a, in_f()));")
        .rust(|i, o| {
            let (count, a) = (i.u(), i.f());
            o.u(first_share(count, a, i.f()));
        })
        .edge(Row::new().u(1).f(1.0).f(1.0))
        .edge(Row::new().u(1 << 31).f(1.0).f(0.0))
        .edge(Row::new().u(1 << 31).f(0.0).f(1.0))
        .edge(Row::new().u(1 << 31).f(1e-30).f(1e30))
        .edge(Row::new().u(1 << 31).f(1e30).f(1e-30))
        .seeded(1000, |r| {
            let count = 1 + r.below(1 << 31);
            Row::new()
                .u(count)
                .f(r.log_range(1e-20, 1e20))
                .f(r.log_range(1e-20, 1e20))
        })
}

fn tree(r: &mut Rng) -> Row {
    SHAPE
        .into_iter()
        .fold(Row::new(), |row, shape| node(row, r, shape))
}

fn descent() -> Twin {
    Twin::new("tree_choice", "light/tree/descent")
        .also(&["tree_pmf"])
        .prelude(nodes())
        .glsl(&format!(
            "{} vec3 p = in_vec3(); vec3 n = in_vec3(); uint a = in_u(); uint b = in_u();
             TreeChoice c = tree_choice(p, n, all_tickets(uvec4(a, b, a, b)));
             out_u(c.pmf > 0.0 ? c.light : 0u); out_f(c.pmf); out_f(tree_pmf(light_trails[in_u()], p, n));",
            fill()
        ))
        .rust(|i, o| {
            let nodes = [(); 7].map(|()| read_node(i));
            let (p, n, a, b) = (i.vec3(), i.vec3(), i.u(), i.u());
            let c = tree_choice(&nodes, p, n, all_tickets([a, b, a, b]));
            o.u(if c.pmf > 0.0 { c.light } else { 0 });
            o.f(c.pmf);
            o.f(tree_pmf(&nodes, TRAILS[i.u() as usize], p, n));
        })
        .seeded(3000, |r| {
            let row = tree(r);
            place(row, r).u(r.u32()).u(r.u32()).u(r.below(4))
        })
}

fn first_shares() -> Twin {
    Twin::new("first_child_share", "light/tree/descent")
        .prelude(nodes())
        .glsl(&format!(
            "{} vec3 p = in_vec3(); vec3 n = in_vec3(); out_u(first_child_share(4u * in_u(), 0x80000000u, p, n));",
            fill()
        ))
        .rust(|i, o| {
            let nodes = [(); 7].map(|()| read_node(i));
            let (p, n) = (i.vec3(), i.vec3());
            o.u(first_child_share(&nodes, 4 * i.u(), 1 << 31, p, n));
        })
        .seeded(1000, |r| {
            let row = tree(r);
            place(row, r).u(r.below(2))
        })
}
