// Counts voxel values into equal bins. Each work group counts an 8 x 8 column of voxels in shared memory and
// adds the result to the global counts once, so contended atomics stay local. VISIBLE: counts only voxels on
// the visible side of the sculpture (visibleSide() of scene.glsl). In: texture 0 data, with VISIBLE 1
// sculpture. Out: storage 0 counts[bins].
// variants: VISIBLE=0;VISIBLE=1
layout(local_size_x = 8, local_size_y = 8) in;

#include "field/shaders/bindings.glsl"
layout(binding = kDataTexture) uniform sampler3D dataTexture;
layout(std430, binding = kCountsStorage) buffer Counts { uint counts[]; };

uniform ivec3 first; // of the voxels that count
uniform ivec3 last;
uniform int bins;
uniform vec3 valueScaleOffset; // z 1 if values are whole numbers
uniform vec2 valueRange;
uniform int firstRow; // of work groups
#if VISIBLE
layout(binding = kSculptureTexture) uniform sampler3D sculptureTexture;
uniform int sculptureView; // 1 cut, 2 probe

bool isVisible(ivec3 voxel) {
    float sculpture = texelFetch(sculptureTexture, voxel, 0).r;
    return sculptureView == 1 ? 0.5 - sculpture - 1e-6 >= 0.0 : sculpture >= 0.5;
}
#else
bool isVisible(ivec3 voxel) { return true; }
#endif

shared uint localCounts[4096];

void main() {
    for (int i = int(gl_LocalInvocationIndex); i < bins; i += 64) {
        localCounts[i] = 0u;
    }
    barrier();
    ivec2 column = first.xy + ivec2(gl_GlobalInvocationID.xy) + ivec2(0, 8 * firstRow);
    if (all(lessThanEqual(column, last.xy))) {
        float scale = valueRange.y > valueRange.x ? float(bins) / (valueRange.y - valueRange.x) : 0.0;
        float margin = max(valueRange.y - valueRange.x, 1.0); // rounding is far below it
        for (int z = first.z; z <= last.z; ++z) {
            float value =
                texelFetch(dataTexture, ivec3(column, z), 0).r * valueScaleOffset.x + valueScaleOffset.y;
            value = valueScaleOffset.z > 0.5 ? round(value) : value;
            // Non-finite voxels are stored far below, and what is not usual lies far away on either side.
            bool isUsual = value >= valueRange.x - margin && value <= valueRange.y + margin;
            if (isUsual && isVisible(ivec3(column, z))) {
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
