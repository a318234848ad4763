// The differences of four groups of a pixel's samples, in pairs. Twin of src/reference/film/film_quarters.rs.

// uses: film/pixel_sum

// Adds sample number n, counted from 1, of index n - 1. A broken one counts as 0, as in the film.
void film_quarters(inout FilmQuarters quarters, vec3 radiance, uint n) {
    vec3 x = is_summable(radiance) ? radiance : vec3(0.0);
    bool odd = (n & 1u) == 0u;
    quarters.even = odd ? quarters.even : x - quarters.even;
    quarters.odd = odd ? x - quarters.odd : quarters.odd;
}
