// Four quarters of every pixel's samples, stored in a buffer next to the film, for `--denoise`.
// uses: film/film_quarters

void moments_sample(uint lane, vec3 radiance, uint n) {
    FilmQuarters kept = quarters[lane];
    film_quarters(kept, radiance, n);
    quarters[lane] = kept;
}
