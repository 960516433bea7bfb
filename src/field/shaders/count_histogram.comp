// Counts voxel values into equal bins. Each work group counts an 8 x 8 column of voxels in shared memory and adds the
// result to the global counts once, so contended atomics stay local.
// In: texture 0 data. Out: storage 0 counts[bins].
layout(local_size_x = 8, local_size_y = 8) in;

layout(binding = 0) uniform sampler3D dataTexture;
layout(std430, binding = 0) buffer Counts { uint counts[]; };

layout(location = 0) uniform ivec3 dims;
layout(location = 1) uniform int bins;
layout(location = 2) uniform vec2 valueScaleOffset;
layout(location = 3) uniform vec2 valueRange;

shared uint localCounts[4096];

void main() {
    for (int i = int(gl_LocalInvocationIndex); i < bins; i += 64) {
        localCounts[i] = 0u;
    }
    barrier();
    ivec2 column = ivec2(gl_GlobalInvocationID.xy);
    if (all(lessThan(column, dims.xy))) {
        float scale = valueRange.y > valueRange.x ? float(bins) / (valueRange.y - valueRange.x) : 0.0;
        for (int z = 0; z < dims.z; ++z) {
            float value = texelFetch(dataTexture, ivec3(column, z), 0).r * valueScaleOffset.x + valueScaleOffset.y;
            if (value > -1e29) { // non-finite voxels are stored far below
                int bin = clamp(int((value - valueRange.x) * scale), 0, bins - 1);
                atomicAdd(localCounts[bin], 1u);
            }
        }
    }
    barrier();
    for (int i = int(gl_LocalInvocationIndex); i < bins; i += 64) {
        if (localCounts[i] > 0u) {
            atomicAdd(counts[i], localCounts[i]);
        }
    }
}
