// The nearest hit by the hierarchy that src/flat/bvh builds.
//
// Ylitie, Karras, Laine, Efficient Incoherent Ray Traversal on GPUs Through Compressed Wide BVHs, HPG 2017, section 4.
// A group is the first inner child of a node and a word: bits 24 ... 31 mark the children still to be visited, by
// priority, bits 0 ... 7 the slots with inner children.
//
// Both loops test at their end. With the test at the beginning, a driver that runs lanes in lockstep would run the body
// once more, all lanes masked off, to find that none continues (a tenth of the time on Mesa's llvmpipe).
//
// The composer declares the words of nodes, uvec4 bvh_words[], and uint bvh_references[]; STACK, the number of entries
// that the build has found sufficient; REACH, the largest coordinate.

// uses: constants/none, math/steps, shape/ray, shape/bvh/bits, shape/bvh/slabs, <leaf>

const uint WAITING = 0xff000000u;

uvec2 bvh_stack[STACK];

// The lesser of `best` and the nearest hit with any primitive in the hierarchy but `skip`, by (t, shape, prim); with
// `any`, the first hit found.
Hit nearest_bvh(Ray ray, Target skip, Hit best, bool any) {
    Hit nearest = best;
    Slabs slabs = slabs_of(ray.o, ray.d, REACH);
    begin_leaves(ray);
    uvec2 group = uvec2(0u, 0x80000000u);
    uint depth = 0u;
    do {
        loop_steps += 1u;
        uint priority = highest_bit(group.y >> 24u);
        group.y ^= 0x01000000u << priority;
        if ((group.y & WAITING) != 0u) {
            bvh_stack[depth] = group;
            depth += 1u;
        }
        // Inner children follow one another in the order of slots.
        uint slot = priority ^ slabs.octant;
        uint node = 5u * (group.x + uint(bitCount(group.y & ((1u << slot) - 1u))));
        uvec4 head = bvh_words[node];
        uvec4 children = bvh_words[node + 1u];
        uint hits = node_hits(slabs, head, children.zw, bvh_words[node + 2u], bvh_words[node + 3u],
                              bvh_words[node + 4u], nearest.t);
        uint leaves = hits & ~WAITING;
        if (leaves != 0u) {
            do {
                loop_steps += 1u;
                uint i = highest_bit(leaves);
                leaves ^= 1u << i;
                nearest = nearer_leaf(bvh_references[children.y + i], ray, skip, nearest);
                leaves = any && nearest.shape != NONE ? 0u : leaves;
            } while (leaves != 0u);
        }
        loop_failed = loop_failed || leaves != 0u;
        group = uvec2(children.x, (hits & WAITING) | (head.w >> 24u));
        if (any && nearest.shape != NONE) {
            group.y = 0u;
            depth = 0u;
        }
        if ((group.y & WAITING) == 0u && depth != 0u) {
            depth -= 1u;
            group = bvh_stack[depth];
        }
    } while ((group.y & WAITING) != 0u);
    // A driver that ends loops early leaves some work undone.
    loop_failed = loop_failed || depth != 0u || (group.y & WAITING) != 0u;
    return nearest;
}
