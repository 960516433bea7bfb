// The one place where shaders ask what is at a point of the document. Later kinds of content (added material,
// displacement, bricked storage) go in here and nowhere else.
//
// Spaces: voxel space has voxel centres at integers; texture space is (p + 0.5) / dims; world is LPS millimetres.
// Bindings: uniform block 0; textures 0 data, 1 sculpture, 2 segmentation (field::SceneBinding).

layout(std140, binding = 0) uniform SceneBlock {
    mat4 worldFromVoxel;
    mat4 voxelFromWorld;
    ivec4 dims;      // xyz voxels, w sculpture view: 0 whole, 1 cut, 2 probe
    vec4 spacing;    // xyz mm, w step mm
    vec4 valueScale; // x scale, y offset, z 1 if values are whole numbers, w tolerance of comparisons
    vec4 range;      // xy displayed range, zw grey window
    vec4 sceneFlags; // x 1 if there is a segmentation, yzw 1 / dims
};

layout(binding = 0) uniform sampler3D dataTexture;
layout(binding = 1) uniform sampler3D sculptureTexture;
layout(binding = 2) uniform sampler3D segmentationTexture;

struct SceneSample {
    float value;        // in the volume's unit
    float sculpture;    // 0 untouched .. 1 cut away
    float dataInside;   // > 0 inside the displayed range, < 0 outside; continuous, in the volume's unit
    float uncut;        // >= 0 on the visible side of the sculpture; continuous, 0.5 level at 0
};

vec3 textureFromVoxel(vec3 p) { return (p + 0.5) * sceneFlags.yzw; }

#ifdef TRICUBIC
#include "field/shaders/tricubic.glsl"
#else
float dataAt(vec3 p) { return textureLod(dataTexture, textureFromVoxel(p), 0.0).r * valueScale.x + valueScale.y; }
#endif

// The stored value of one voxel, exact.
float voxelValue(ivec3 v) {
    float value = texelFetch(dataTexture, v, 0).r * valueScale.x + valueScale.y;
    return valueScale.z > 0.5 ? round(value) : value;
}

float sculptureAt(vec3 p) { return textureLod(sculptureTexture, textureFromVoxel(p), 0.0).r; }

float segmentationAt(vec3 p) { return textureLod(segmentationTexture, textureFromVoxel(p), 0.0).r; }

// How far a value is inside the displayed range.
float insideRange(float value) { return min(value - range.x, range.y - value) + valueScale.w; }

// Cut view shows sculpture < 0.5, probe view >= 0.5.
float visibleSide(float sculpture) {
    return dims.w == 0 ? 1.0 : (dims.w == 1 ? 0.5 - sculpture - 1e-6 : sculpture - 0.5);
}

SceneSample sampleScene(vec3 p) {
    SceneSample s;
    s.value = dataAt(p);
    s.sculpture = sculptureAt(p);
    s.dataInside = insideRange(s.value);
    s.uncut = visibleSide(s.sculpture);
    return s;
}

bool isVisible(SceneSample s) { return s.dataInside >= 0.0 && s.uncut >= 0.0; }

// Gradient in value per mm along the patient's axes (world), from central differences one voxel wide; with TRICUBIC the
// data's own derivative.
vec3 worldGradient(vec3 voxelGradient) { return transpose(mat3(voxelFromWorld)) * voxelGradient; }

#ifdef TRICUBIC
vec3 dataGradient(vec3 p) { return worldGradient(voxelGradientAt(p)); }
#else
vec3 dataGradient(vec3 p) {
    const vec3 e = vec3(1.0, 0.0, 0.0);
    return worldGradient(0.5 * vec3(dataAt(p + e.xyy) - dataAt(p - e.xyy), dataAt(p + e.yxy) - dataAt(p - e.yxy),
                                    dataAt(p + e.yyx) - dataAt(p - e.yyx)));
}
#endif

vec3 sculptureGradient(vec3 p) {
    const vec3 e = vec3(1.0, 0.0, 0.0);
    return worldGradient(0.5 * vec3(sculptureAt(p + e.xyy) - sculptureAt(p - e.xyy),
                                    sculptureAt(p + e.yxy) - sculptureAt(p - e.yxy),
                                    sculptureAt(p + e.yyx) - sculptureAt(p - e.yyx)));
}

vec3 segmentationGradient(vec3 p) {
    const vec3 e = vec3(1.0, 0.0, 0.0);
    return worldGradient(0.5 * vec3(segmentationAt(p + e.xyy) - segmentationAt(p - e.xyy),
                                    segmentationAt(p + e.yxy) - segmentationAt(p - e.yxy),
                                    segmentationAt(p + e.yyx) - segmentationAt(p - e.yyx)));
}
