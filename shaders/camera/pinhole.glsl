// A pinhole: all rays start at the eye.
// Twin of src/reference/camera/pinhole.rs; struct Camera comes with the layout of buffers.

// uses: math/vec

// Unit direction of the ray through the point (a, b) of the pixel in column x and row y, row 0 at the top.
// (a, b) lies in [0, 1)^2, (0, 0) is the pixel's lower left corner.
vec3 camera_direction(Camera camera, uint x, uint y, float a, float b) {
    uint row = camera.height - 1u - y;
    // dx = 2 (x + a) / W - 1, dy = 2 (H - 1 - y + b) / H - 1
    float dx = 2.0 * (float(x) + a) / float(camera.width) - 1.0;
    float dy = 2.0 * (float(row) + b) / float(camera.height) - 1.0;
    return normalize3(camera.forward + camera.right * dx + camera.up * dy);
}
