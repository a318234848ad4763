// Four quarters of every pixel's samples, kept apart in a buffer beside the film, for `--denoise`.
// uses: film/film_quarters

void moments_sample(uint lane, vec3 radiance, uint n) {
    FilmQuarters kept = quarters[lane];
    film_quarters(kept, radiance, n);
    quarters[lane] = kept;
}
