// The decisions of a path as one word: two paths that decided alike have the same.
// Twin of src/reference/path/signature.rs.
// uses: sampler/random

const uint DECISION_VERTEX = 1u;
const uint DECISION_ESCAPE = 2u;
const uint DECISION_LIGHT = 3u;
const uint DECISION_CONNECTION = 4u;

// `chain` with one more decision: its kind, and what was decided.
uint decide(uint chain, uint decision, uint a, uint b) {
    return pcg4d(uvec4(chain, decision, a, b)).x;
}

// Of a path whose vertices and whose connections made these chains.
uint path_signature(uint vertices, uint connections) {
    return decide(vertices, 0u, connections, 0u);
}
