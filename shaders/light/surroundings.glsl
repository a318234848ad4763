// A picture of all directions as a light: its radiance is constant within a texel, drawn by luminance times solid angle.
// Twin of src/reference/light/surroundings.rs.
// uses: light/outside, light/sample, math/frame, math/steps, math/elementary/sincos, math/elementary/turns, <surroundings_words>

// The texel seen along wi: row * width + column, from the top left.
uint surroundings_texel(vec3 wi) {
    Surroundings s = surroundings[0];
    vec3 d = to_local(Frame(s.x, s.y, s.z), wi);
    // u = 1/2 - phi/2pi, v = theta/pi
    float u = 0.5 - turns(d.y, d.x);
    float v = 2.0 * turns(sqrt(d.x * d.x + d.y * d.y), d.z);
    uint column = uint(u * float(s.width));
    uint row = uint(v * float(s.height));
    column = column < s.width ? column : s.width - 1u;
    row = row < s.height ? row : s.height - 1u;
    return row * s.width + column;
}

// The radiance in the picture's file.
vec3 surroundings_radiance(uint texel) {
    uint i = texel * 3u;
    return vec3(surroundings_value(i), surroundings_value(i + 1u), surroundings_value(i + 2u));
}

// The probability of the texel over its solid angle: that of its row, times its count out of 2^24 within it.
float surroundings_texel_pdf(uint texel) {
    uint width = surroundings[0].width;
    bool first = texel % width == 0u;
    uint before = surroundings_end(first ? texel : texel - 1u);
    uint count = surroundings_end(texel) - (first ? 0u : before);
    return float(count) * surroundings_rows[texel / width].pdf;
}

// The first row whose counts end above u24 < 2^24.
uint surroundings_row(uint u24) {
    uint low = 0u;
    uint high = surroundings[0].height - 1u;
    while (low < high) {
        loop_steps += 1u;
        uint middle = (low + high) / 2u;
        bool after = surroundings_rows[middle].end <= u24;
        low = after ? middle + 1u : low;
        high = after ? high : middle;
    }
    return low;
}

// The texel of the row that begins with texel `first`, by the same rule.
uint surroundings_column(uint first, uint u24) {
    uint low = first;
    uint high = first + surroundings[0].width - 1u;
    while (low < high) {
        loop_steps += 1u;
        uint middle = (low + high) / 2u;
        bool after = surroundings_end(middle) <= u24;
        low = after ? middle + 1u : low;
        high = after ? high : middle;
    }
    return low;
}

// Where u24 lies between the counts `begin` and `end`, from 0 to 1.
float fraction_of(uint u24, uint begin, uint end) {
    return (float(u24 - begin) + 0.5) / float(end - begin);
}

// cos theta and sin theta of the place x between the edges of a row, by the quantity drawn uniformly: cos theta itself,
// or sin^2(theta/2) = h from the nearer pole. d omega = dphi dcos theta = 2 dphi dh.
vec2 height_and_radius(uint row, uint height, float x) {
    bool middle = 4u * row >= height && 4u * (row + 1u) <= 3u * height;
    bool south = 2u * row + 1u > height;
    float from_pole = 1.0 - (x + x);
    float z = south ? -from_pole : from_pole;
    float squared = middle ? 1.0 - x * x : 4.0 * (x * (1.0 - x));
    return vec2(middle ? x : z, sqrt(squared));
}

// A direction within a texel, `a` of its width from the left and `b` of its solid angle from the top.
vec3 surroundings_direction(uint row, uint column, float a, float b) {
    Surroundings s = surroundings[0];
    SurroundingsRow edges = surroundings_rows[row];
    vec2 zr = height_and_radius(row, s.height, edges.top + b * (edges.bottom - edges.top));
    // phi = 2pi (1/2 - u)
    vec2 sincos = sincos_2pi((float(column) + a) / float(s.width));
    vec3 local = vec3(-(zr.y * sincos.y), zr.y * sincos.x, zr.x);
    return to_world(Frame(s.x, s.y, s.z), local);
}

// Its pdf is that of the texel seen along the direction, which rounding may make a neighbour of the one drawn: the
// radiance that is divided by the pdf is that texel's.
LightSample surroundings_light_sample(vec2 u) {
    uint width = surroundings[0].width;
    uint row24 = uint(u.y * 16777216.0);
    uint row = surroundings_row(row24);
    uint row_begin = row > 0u ? surroundings_rows[row > 0u ? row - 1u : 0u].end : 0u;
    float b = fraction_of(row24, row_begin, surroundings_rows[row].end);
    uint column24 = uint(u.x * 16777216.0);
    uint first = row * width;
    uint texel = surroundings_column(first, column24);
    uint before = surroundings_end(texel > first ? texel - 1u : first);
    float a = fraction_of(column24, texel > first ? before : 0u, surroundings_end(texel));
    vec3 wi = surroundings_direction(row, texel - first, a, b);
    uint seen = surroundings_texel(wi);
    return LightSample(wi, -1.0, surroundings_texel_pdf(seen), 1.0, seen);
}

// The light seen along wi, times `scale`.
Outside surroundings_outside(vec3 scale, vec3 wi) {
    uint texel = surroundings_texel(wi);
    return Outside(scale * surroundings_radiance(texel), surroundings_texel_pdf(texel));
}
