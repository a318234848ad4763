// The ray that leaves a vertex.
// Twin of src/reference/path/spawn.rs.
// uses: constants/ray, shape/ray, path/vertex, <crossing>, <self_distance>

// Along wi, through the surface or not, by a path that has come through `medium`.
Ray spawn_ray(Vertex v, vec3 wi, bool through, uint medium) {
    bool goes_outside = v.outside != through;
    return Ray(v.p, FAR, wi, v.shape, v.prim, goes_outside ? START_OUTSIDE : START_INSIDE,
               self_distance(v.shape, v.p, v.ng, wi), medium_after(v, through, medium));
}
