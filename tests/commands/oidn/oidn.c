// Stands in for Open Image Denoise 2: its C API, as far as vkpt calls it. The colour that it returns is the mean of colour, albedo and
// |normal|, all of which must be there; a picture of albedo or normal alone comes back as it is.

#include <math.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

struct image {
    const float *values;
    size_t width, height;
};
struct filter {
    struct image color, albedo, normal, output;
    bool hdr, clean;
    int commits;
};

static int devices, filters;
static const char *failure;

void *oidnNewDevice(int type) { return type == 1 ? &devices : NULL; }
void oidnCommitDevice(void *device) { devices += device == &devices; }
void oidnReleaseDevice(void *device) { devices -= device == &devices; }
int oidnGetDeviceInt(void *device, const char *name) {
    return device == &devices && strcmp(name, "version") == 0 ? 20399 : 0;
}
int oidnGetDeviceError(void *device, const char **message) {
    (void)device;
    *message = failure;
    int code = failure != NULL;
    failure = NULL;
    return code;
}
void *oidnNewFilter(void *device, const char *type) {
    if (device != &devices || devices != 1 || strcmp(type, "RT") != 0)
        return NULL;
    ++filters;
    return calloc(1, sizeof(struct filter));
}
void oidnReleaseFilter(void *filter) {
    --filters;
    free(filter);
}
void oidnSetFilterBool(struct filter *filter, const char *name, bool value) {
    if (strcmp(name, "hdr") == 0)
        filter->hdr = value;
    if (strcmp(name, "cleanAux") == 0)
        filter->clean = value;
}
void oidnSetSharedFilterImage(struct filter *filter, const char *name, void *values, int format, size_t width, size_t height,
                              size_t offset, size_t pixel, size_t row) {
    struct image image = {values, width, height};
    if (format != 3 || offset != 0 || pixel != 0 || row != 0)
        failure = "another format";
    if (strcmp(name, "color") == 0)
        filter->color = image;
    if (strcmp(name, "albedo") == 0)
        filter->albedo = image;
    if (strcmp(name, "normal") == 0)
        filter->normal = image;
    if (strcmp(name, "output") == 0)
        filter->output = image;
}
void oidnCommitFilter(struct filter *filter) { ++filter->commits; }
void oidnExecuteFilter(struct filter *filter) {
    struct image color = filter->color, albedo = filter->albedo, normal = filter->normal;
    size_t count = 3 * filter->output.width * filter->output.height;
    float *out = (float *)filter->output.values;
    if (getenv("STAND_IN_FAILS") != NULL || filter->commits != 1 || filters != 1) {
        failure = "out of patience";
    } else if (color.values == NULL) {
        memcpy(out, albedo.values != NULL ? albedo.values : normal.values, count * sizeof(float));
    } else if (!filter->hdr || !filter->clean || albedo.values == NULL || normal.values == NULL) {
        failure = "inputs are missing";
    } else {
        for (size_t i = 0; i < count; ++i)
            out[i] = (color.values[i] + albedo.values[i] + fabsf(normal.values[i])) / 3;
    }
}
