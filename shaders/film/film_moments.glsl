// The moments of one pixel's samples, from which the standard error of their mean follows.
// Twin of src/reference/film/film_moments.rs.

// uses: film/pixel_sum

// Adds sample number n, counted from 1; a broken one counts as 0, as in the film.
void film_moments(inout FilmMoments moments, vec3 radiance, uint n) {
    vec3 x = is_summable(radiance) ? radiance : vec3(0.0);
    // delta = x - mean; mean += delta / n; m2 += delta (x - mean): Welford, Technometrics 4, 1962;
    // Knuth, The Art of Computer Programming 2, 4.2.2, (15) and (16)
    vec3 delta = x - moments.mean;
    PixelSum mean = film_add(PixelSum(moments.mean, moments.mean_comp), delta / float(n));
    PixelSum m2 = film_add(PixelSum(moments.m2, moments.m2_comp), delta * (x - mean.sum));
    moments.mean = mean.sum;
    moments.mean_comp = mean.comp;
    moments.m2 = m2.sum;
    moments.m2_comp = m2.comp;
}
