// Counts voxels by gradient magnitude at their centres. Each invocation goes along a column in z and keeps
// three values of it; voxels in a row that fall into the same bin are added up before they are counted.
// COUNT: 0 logarithmic bins (32 an octave) and the largest magnitude, 1 equal bins of magnitude, 2 equal bins
// of intensity (fastest) and magnitude; 3 none: the magnitudes themselves are kept, as parts of ranges.w.
// In: texture 0 data. Out: storage 0 counts[]; for COUNT 0 its last entry holds the bits of the largest
// magnitude. For COUNT 3 image 0 instead.
// variants: COUNT=0;COUNT=1;COUNT=2;COUNT=3
layout(local_size_x = 8, local_size_y = 8) in;

#include "field/shaders/bindings.glsl"
layout(binding = kDataTexture) uniform sampler3D dataTexture;
#if COUNT == 3
layout(r16, binding = kTargetImage) uniform writeonly image3D magnitudes;
#else
layout(std430, binding = kCountsStorage) buffer Counts { uint counts[]; };
#endif

uniform ivec3 dims;
uniform ivec2 bins;
uniform vec3 valueScale; // x scale, y offset, z 1 if values are whole numbers
uniform vec4 ranges;     // xy values, zw magnitudes
uniform mat4 worldFromVoxelGradient;
uniform int firstRow; // of work groups

const uint kLogFirst = (127u - 64u) << 5;

#if COUNT < 2
shared uint localCounts[4096]; // contended atomics stay in the work group
#endif

float valueAt(int x, int y, int z) {
    float value = texelFetch(dataTexture, ivec3(x, y, z), 0).r * valueScale.x + valueScale.y;
    return valueScale.z > 0.5 ? round(value) : value;
}

// Which of `count` equal bins over lo..hi; the upper end belongs to the last one.
int equalBin(float x, float lo, float hi, int count) {
    return clamp(int((x - lo) * (hi > lo ? float(count) / (hi - lo) : 0.0)), 0, count - 1);
}

// -1: not counted.
int binOf(float value, float magnitude) {
#if COUNT == 0
    return clamp(int(floatBitsToUint(magnitude) >> 18) - int(kLogFirst), 0, 4095);
#elif COUNT == 3
    return -1;
#elif COUNT == 1
    return magnitude > ranges.w ? -1 : equalBin(magnitude, ranges.z, ranges.w, bins.x);
#else
    int row = equalBin(magnitude, ranges.z, ranges.w, bins.y);
    return magnitude > ranges.w ? -1 : row * bins.x + equalBin(value, ranges.x, ranges.y, bins.x);
#endif
}

void add(int bin, uint number) {
    if (bin >= 0) {
#if COUNT == 2
        atomicAdd(counts[bin], number);
#elif COUNT < 2
        atomicAdd(localCounts[bin], number);
#endif
    }
}

void countColumn(ivec2 column) {
    ivec2 before = max(column - 1, ivec2(0));
    ivec2 after = min(column + 1, dims.xy - 1);
    float below = valueAt(column.x, column.y, 0);
    float here = below;
    float largest = 0.0;
    int bin = -1;
    uint number = 0u;
    for (int z = 0; z < dims.z; ++z) {
        float above = valueAt(column.x, column.y, min(z + 1, dims.z - 1));
        vec2 left = vec2(valueAt(before.x, column.y, z), valueAt(column.x, before.y, z));
        vec2 right = vec2(valueAt(after.x, column.y, z), valueAt(column.x, after.y, z));
        float magnitude = length(mat3(worldFromVoxelGradient) * (0.5 * vec3(right - left, above - below)));
        float least = min(min(min(left.x, left.y), min(right.x, right.y)), min(min(below, above), here));
        // Non-finite voxels are stored far below.
        int next = least > -1e29 ? binOf(here, magnitude) : -1;
        largest = least > -1e29 ? max(largest, magnitude) : largest;
#if COUNT == 3
        // Non-finite voxels and their neighbours have none.
        imageStore(magnitudes, ivec3(column, z), vec4(least > -1e29 ? min(magnitude / ranges.w, 1.0) : 0.0));
#endif
        if (next != bin) {
            add(bin, number);
            bin = next;
            number = 0u;
        }
        ++number;
        below = here;
        here = above;
    }
    add(bin, number);
#if COUNT == 0
    atomicMax(counts[4096], floatBitsToUint(largest)); // magnitudes are ordered as their bits are
#endif
}

void main() {
    ivec2 column = ivec2(gl_GlobalInvocationID.xy) + ivec2(0, 8 * firstRow);
#if COUNT < 2
    for (int i = int(gl_LocalInvocationIndex); i < bins.x; i += 64) {
        localCounts[i] = 0u;
    }
    barrier();
#endif
    if (all(lessThan(column, dims.xy))) {
        countColumn(column);
    }
#if COUNT < 2
    barrier();
    for (int i = int(gl_LocalInvocationIndex); i < bins.x; i += 64) {
        if (localCounts[i] > 0u) {
            atomicAdd(counts[i], localCounts[i]);
        }
    }
#endif
}
