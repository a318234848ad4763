// A pixel of the film: the sum of its samples, and its counters.
// Twin of src/reference/film/film_pixel.rs.

// uses: math/finite, math/vec, film/pixel_sum

// A broken sample, or one too large to add up, counts as 0, and by its cause. Even and odd indices are the two groups.
void film_sample(inout FilmPixel pixel, vec3 radiance) {
    bool broken = !is_summable(radiance);
    bool nan = has_nan(radiance);
    pixel.nan += nan ? 1u : 0u;
    pixel.infinite += broken && !nan ? 1u : 0u;
    vec3 x = broken ? vec3(0.0) : radiance;
    PixelSum sum = film_add(PixelSum(pixel.sum, pixel.comp), x);
    pixel.sum = sum.sum;
    pixel.comp = sum.comp;
    pixel.contrast = x - pixel.contrast;
    float brightest = max_component(x);
    bool larger = brightest > pixel.largest;
    pixel.largest = larger ? brightest : pixel.largest;
    pixel.largest_sample = larger ? pixel.samples : pixel.largest_sample;
    pixel.samples += 1u;
}
