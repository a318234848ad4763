// The choice of one of many lights: down a tree, at each node by the importance of its halves.
// Twin of src/reference/light/tree/descent.rs.
// uses: math/steps, light/tree/importance, light/tree/tickets

struct TreeChoice {
    uint light;
    // Probability of the choice; 0: no light can contribute here.
    float pmf;
};

// The share of the first child of node i, the one that follows it, among `count` tickets; 2^32 - 1 if neither can contribute.
uint first_child_share(uint i, uint count, vec3 p, vec3 n) {
    float a = node_importance(light_nodes[i + 1u], p, n);
    float b = node_importance(light_nodes[light_nodes[i].child], p, n);
    uint share = first_share(count, a, b);
    return a + b > 0.0 ? share : 0xffffffffu;
}

// A light for the point p with normal n, or n = 0.
TreeChoice tree_choice(vec3 p, vec3 n, Tickets all) {
    Tickets t = all;
    uint i = 0u;
    float pmf = 1.0;
    while (light_nodes[i].leaf == 0u && pmf > 0.0) {
        loop_steps += 1u;
        uint share = first_child_share(i, t.count, p, n);
        bool first = t.drawn < share;
        uint count = first ? share : t.count - share;
        pmf *= share == 0xffffffffu ? 0.0 : float(count) / float(t.count);
        i = first ? i + 1u : light_nodes[i].child;
        t.drawn = first ? t.drawn : t.drawn - share;
        t.count = count;
        t = refilled(t);
    }
    return TreeChoice(light_nodes[i].child, pmf);
}

// The probability of that choice for the light that `trail` leads to.
float tree_pmf(uint trail, vec3 p, vec3 n) {
    Tickets t = all_tickets(uvec4(0u));
    uint i = 0u;
    uint way = trail;
    float pmf = 1.0;
    while (light_nodes[i].leaf == 0u && pmf > 0.0) {
        loop_steps += 1u;
        uint share = first_child_share(i, t.count, p, n);
        bool first = (way & 1u) == 0u;
        uint count = first ? share : t.count - share;
        pmf *= share == 0xffffffffu ? 0.0 : float(count) / float(t.count);
        i = first ? i + 1u : light_nodes[i].child;
        way = way >> 1u;
        t.count = count;
        t = refilled(t);
    }
    return pmf;
}
