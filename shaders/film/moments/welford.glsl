// The moments of every pixel, stored in a buffer next to the film, for `--aov stderr`.
// uses: film/film_moments

void moments_sample(uint lane, vec3 radiance, uint n) {
    FilmMoments kept = moments[lane];
    film_moments(kept, radiance, n);
    moments[lane] = kept;
}
