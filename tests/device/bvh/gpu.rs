//! The kernels' hierarchy, on the device, against brute force on the CPU.

use rayon::prelude::*;
use vkpt::flat::bvh::reference::decode;
use vkpt::flat::{self, bvh, bvh::Bvh};
use vkpt::gpu::{Buffer, BufferUse, Device, Pipeline};
use vkpt::kernel::{Composer, Slot, compile};
use vkpt::layout::{self, GpuStruct};
use vkpt::prepared::{NONE, Prepared, device};
use vkpt::reference::shape::Hit;

use super::brute::{World, bits, is_some_hit};
use super::rays::{Query, Rays};
use super::scenes;
use super::tree::ALL_KINDS;
use crate::common;

/// Queries answered by one dispatch.
const BATCH: usize = 1 << 15;
const QUERY_WORDS: usize = 16;
const HIT_WORDS: usize = 8;

const ROOT: &str = "// uses: shape/bvh/nearest
layout(local_size_x = 64) in;
void main() {
    uint i = gl_GlobalInvocationID.x;
    uvec4 a = queries[4u * i];
    uvec4 b = queries[4u * i + 1u];
    uvec4 c = queries[4u * i + 2u];
    Ray ray = Ray(uintBitsToFloat(a.xyz), FAR, uintBitsToFloat(uvec3(a.w, b.x, b.y)), b.z, b.w, c.x, uintBitsToFloat(c.y),
                  NONE);
    uvec4 d = queries[4u * i + 3u];
    Hit hit = nearest_bvh(ray, Target(c.w, d.x), no_hit(uintBitsToFloat(c.z)), d.y != 0u);
    hits[2u * i] = uvec4(floatBitsToUint(hit.t), hit.shape, hit.prim, loop_failed ? 1u : 0u);
    hits[2u * i + 1u] = uvec4(floatBitsToUint(hit.uv), loop_steps, 0u);
}
";

/// No two faces coincide.
const NEVER_COVERED: &str = "// uses: shape/ray
bool sphere_covered(bool asked, Ray ray, uint shape, uint prim, float t, bool enters) { return false; }
bool box_covered(bool asked, Ray ray, uint shape, uint prim, float t, bool enters) { return false; }
bool cylinder_covered(bool asked, Ray ray, uint shape, uint prim, float t, bool enters) { return false; }
bool mesh_covered(bool asked, Ray ray, uint shape, uint prim, float t, bool enters) { return false; }
";

/// A scene on the device, and the kernel that searches it.
pub struct Search<'a> {
    device: &'a Device,
    pipeline: Pipeline,
    scene: Vec<Buffer>,
    queries: Buffer,
    hits: Buffer,
}

impl<'a> Search<'a> {
    /// `edit` may change the text of a file of the library, by its name.
    pub fn new(
        device: &'a Device,
        prepared: &Prepared,
        bvh: &Bvh,
        edit: impl Fn(&str, &str) -> String,
    ) -> Self {
        let arrays: [(&str, &str, Vec<u8>); 7] = [
            ("uvec4", "bvh_words", bytes(&bvh.nodes)),
            ("uint", "bvh_references", bytes(&bvh.references)),
            (
                "Sphere",
                "spheres",
                bytes(&flat::records(&prepared.primitives.spheres)),
            ),
            (
                "Cuboid",
                "boxes",
                bytes(&flat::records(&prepared.primitives.boxes)),
            ),
            (
                "Cylinder",
                "cylinders",
                bytes(&flat::records(&prepared.primitives.cylinders)),
            ),
            ("float", "triangle_words", bytes(&flat::triangles(prepared))),
            (
                "uint",
                "triangle_shapes",
                bytes(&flat::triangle_shapes(prepared)),
            ),
        ];
        let buffer = |name: &str, bytes: usize| {
            device
                .buffer(name, BufferUse::Storage, bytes as u64)
                .expect("a buffer")
        };
        let mut declarations = String::new();
        let mut scene = Vec::new();
        for (i, (ty, name, bytes)) in arrays.iter().enumerate() {
            declarations += &declaration(i, "readonly ", ty, name);
            scene.push(buffer(name, bytes.len()));
            scene[i].write(bytes).expect("an upload");
        }
        declarations += &declaration(7, "readonly ", "uvec4", "queries");
        declarations += &declaration(8, "", "uvec4", "hits");
        let kernel = compose(prepared, bvh, &declarations, edit);
        Self {
            device,
            pipeline: device
                .pipeline(&kernel, &[BufferUse::Storage; 9], 0)
                .expect("a pipeline"),
            scene,
            queries: buffer("queries", BATCH * QUERY_WORDS * 4),
            hits: buffer("hits", BATCH * HIT_WORDS * 4),
        }
    }

    /// The hits of at most [`BATCH`] queries, in order.
    pub fn nearest(&self, queries: &[Query<f32>]) -> Vec<Hit<f32>> {
        self.search(queries, false)
    }

    /// Any hit of each, if there is one.
    pub fn any(&self, queries: &[Query<f32>]) -> Vec<Hit<f32>> {
        self.search(queries, true)
    }

    fn search(&self, queries: &[Query<f32>], any: bool) -> Vec<Hit<f32>> {
        let words = |q| query_words(q, any);
        let mut words: Vec<[u32; QUERY_WORDS]> = queries.iter().map(words).collect();
        // The rest of the batch repeats the last query.
        words.resize(BATCH, words[words.len() - 1]);
        self.queries
            .write(bytemuck::cast_slice(&words))
            .expect("an upload");
        let mut buffers: Vec<&Buffer> = self.scene.iter().collect();
        buffers.extend([&self.queries, &self.hits]);
        let groups = [(BATCH / 64) as u32, 1, 1];
        self.device
            .dispatch(&self.pipeline, &buffers, &[], groups)
            .expect("a dispatch");
        let bytes = self.hits.read().expect("a download");
        bytes
            .chunks_exact(4 * HIT_WORDS)
            .take(queries.len())
            .map(hit)
            .collect()
    }
}

fn bytes<T: bytemuck::NoUninit>(records: &[T]) -> Vec<u8> {
    bytemuck::cast_slice(records).to_vec()
}

fn declaration(index: usize, access: &str, ty: &str, name: &str) -> String {
    format!(
        "layout(std430, set = 0, binding = {index}) {access}buffer {name}_block {{ {ty} {name}[]; }};\n"
    )
}

fn compose(
    prepared: &Prepared,
    bvh: &Bvh,
    declarations: &str,
    edit: impl Fn(&str, &str) -> String,
) -> vkpt::kernel::Spirv {
    let prelude = format!(
        "const uint STACK = {}u;\nconst float REACH = {:?};\n\
         const uint TRIANGLE_SHAPES = {}u;\n",
        bvh.stack,
        bvh.reach,
        prepared.primitives.triangles.len()
    );
    let structs = [
        layout::Ray::glsl(),
        device::Sphere::glsl(),
        device::Cuboid::glsl(),
        device::Cylinder::glsl(),
    ]
    .concat();
    let mut composer = Composer::new()
        .prelude(prelude + &structs + declarations)
        .slot("covered", Slot::Text(NEVER_COVERED.into()))
        .slot("leaf", Slot::Text(bvh::leaf_text(ALL_KINDS)))
        .slot("triangles", Slot::File("shape/triangle/corners".into()))
        .add("root", ROOT);
    for file in ["shape/bvh/slabs", "shape/bvh/nearest"] {
        let text = vkpt::kernel::file(file).expect("a file of the library");
        composer = composer.add(file, edit(file, text));
    }
    let composed = composer.compose(&["root"]).expect("composes");
    compile(&composed).unwrap_or_else(|e| panic!("{e:?}"))
}

fn query_words(q: &Query<f32>, any: bool) -> [u32; QUERY_WORDS] {
    let (o, d) = (q.ray.o, q.ray.d);
    let mut words = [0; QUERY_WORDS];
    words[..6].copy_from_slice(&[o.x, o.y, o.z, d.x, d.y, d.z].map(f32::to_bits));
    words[6..9].copy_from_slice(&[q.ray.shape, q.ray.prim, q.ray.start]);
    words[9..11].copy_from_slice(&[q.ray.t_self, q.t_max].map(f32::to_bits));
    words[11..14].copy_from_slice(&[q.skip.shape, q.skip.prim, u32::from(any)]);
    words
}

fn hit(bytes: &[u8]) -> Hit<f32> {
    let word = |i: usize| {
        u32::from_ne_bytes([
            bytes[4 * i],
            bytes[4 * i + 1],
            bytes[4 * i + 2],
            bytes[4 * i + 3],
        ])
    };
    assert_eq!(word(3), 0, "a loop ended before its end");
    Hit {
        t: f32::from_bits(word(0)),
        shape: word(1),
        prim: word(2),
        uv: [f32::from_bits(word(4)), f32::from_bits(word(5))],
    }
}

/// A query, the kernel's result and that of brute force.
type Answer = (Query<f32>, Hit<f32>, Hit<f32>);

/// At most [`BATCH`] more queries.
fn answers(search: &Search, world: &World<f32>, source: &mut Rays, count: usize) -> Vec<Answer> {
    let queries: Vec<Query<f32>> = (0..count).map(|_| source.next()).collect();
    let found = search.nearest(&queries);
    let both = queries.into_par_iter().zip(found);
    both.map(|(q, found)| (q, found, world.nearest(&q)))
        .collect()
}

fn differ((_, found, expected): &Answer) -> bool {
    bits(*found) != bits(*expected)
}

/// The first of `count` queries whose answer differs from brute force in any bit, as text.
fn first_difference(search: &Search, prepared: &Prepared, count: usize) -> Option<String> {
    let world = World::<f32>::new(prepared);
    let mut source = Rays::new(prepared, 23);
    let mut left = count;
    while left > 0 {
        let n = left.min(BATCH);
        let answers = answers(search, &world, &mut source, n);
        if let Some((q, found, expected)) = answers.into_iter().find(differ) {
            return Some(format!("{q:?}\n{found:?}\n{expected:?}"));
        }
        left -= n;
    }
    None
}

fn check(count: usize) {
    let Some(device) = common::device() else {
        return;
    };
    for (name, prepared) in scenes::all() {
        let bvh = bvh::build(&prepared, &ALL_KINDS);
        let search = Search::new(device, &prepared, &bvh, |_, text| text.to_owned());
        let difference = first_difference(&search, &prepared, count);
        assert_eq!(difference, None, "{name}");
    }
}

#[test]
fn gpu_equals_brute_force() {
    check(16_384);
}

#[test]
fn any_hit_is_found_where_there_is_one() {
    let Some(device) = common::device() else {
        return;
    };
    let mut further = 0;
    for (name, prepared) in scenes::all() {
        let bvh = bvh::build(&prepared, &ALL_KINDS);
        let search = Search::new(device, &prepared, &bvh, |_, text| text.to_owned());
        let world = World::<f32>::new(&prepared);
        let mut source = Rays::new(&prepared, 24);
        let queries: Vec<Query<f32>> = (0..8192).map(|_| source.next()).collect();
        for (q, any) in queries.iter().zip(search.any(&queries)) {
            let nearest = world.nearest(q);
            assert!(
                is_some_hit(any, nearest),
                "{name}: {q:?}\n{any:?}\n{nearest:?}"
            );
            further += u32::from(any.t > nearest.t);
        }
    }
    assert!(further > 0, "no search ended early");
}

#[test]
#[ignore = "ten million queries: minutes"]
fn gpu_equals_brute_force_at_length() {
    check(1_000_000);
}

/// Without padding a box hides hits on its faces, and no ray reports a false hit.
#[test]
fn boxes_without_padding_hide_hits() {
    let Some(device) = common::device() else {
        return;
    };
    let prepared = scenes::cube();
    let bvh = bvh::build(&prepared, &ALL_KINDS);
    let unpadded = Search::new(device, &prepared, &bvh, |_, text| {
        text.replace("3.814697265625e-6", "0.0")
    });
    let world = World::<f32>::new(&prepared);
    let mut answers = answers(&unpadded, &world, &mut Rays::new(&prepared, 23), 20_000);
    answers.retain(differ);
    assert!(!answers.is_empty());
    for (q, found, expected) in answers {
        let place = |hit: &Hit<f32>| (hit.t, hit.shape, hit.prim);
        assert!(
            place(&found) > place(&expected),
            "{q:?}\n{found:?}\n{expected:?}"
        );
    }
}

/// If a hierarchy has lost a leaf, the queries whose nearest hit was in it notice, all of them and no others.
#[test]
fn a_lost_leaf_is_noticed_by_the_rays_that_hit_it() {
    let Some(device) = common::device() else {
        return;
    };
    let prepared = scenes::blob();
    let mut bvh = bvh::build(&prepared, &ALL_KINDS);
    let lost = lose_a_leaf(&mut bvh);
    let search = Search::new(device, &prepared, &bvh, |_, text| text.to_owned());
    let world = World::<f32>::new(&prepared);
    let answers = answers(&search, &world, &mut Rays::new(&prepared, 23), 20_000);
    let was_lost = |hit: &Hit<f32>| hit.shape != NONE && lost.contains(&hit.prim);
    assert!(answers.iter().any(|(_, _, expected)| was_lost(expected)));
    for answer in &answers {
        assert_eq!(differ(answer), was_lost(&answer.2), "{answer:?}");
    }
}

/// Empties the first leaf of the first node that has one; the triangles that were in it.
fn lose_a_leaf(bvh: &mut Bvh) -> Vec<u32> {
    for words in &mut bvh.nodes {
        let inner = words[3] >> 24;
        for slot in 0..8 {
            let (word, shift) = (6 + slot / 4, 8 * (slot % 4));
            let meta = words[word] >> shift & 0xff;
            if inner >> slot & 1 == 0 && meta != 0 {
                words[word] &= !(0xff << shift);
                let first = (words[5] + (meta & 31)) as usize;
                let count = (meta >> 5).count_ones() as usize;
                let references = &bvh.references[first..first + count];
                return references.iter().map(|&r| decode(r).1 as u32).collect();
            }
        }
    }
    Vec::new()
}
