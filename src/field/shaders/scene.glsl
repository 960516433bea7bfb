// The one place where shaders ask what is at a point of the document. Later kinds of content (added material,
// displacement, bricked storage) go in here and nowhere else.
//
// Spaces: voxel space has voxel centres at integers; texture space is (p + 0.5) / dims; world is LPS
// millimetres. Bindings: uniform block 0; textures 0 data, 1 sculpture, 2 segmentation, 13 labels, with QUADS
// 6 (field::SceneBinding). BRICKS: the data's values are those of a finer level, from bricks (bricks.glsl),
// with FINER_CUTS what was cut is, and with FINER_SEGMENTS so is what belongs to segments, and their labels:
// it is 1, or 2 where opaque and translucent ones are told apart.
// ALL_SEGMENTS: translucent segments count as opaque ones do. SMOOTHED: dataAt()
// gives smoothed values, of textures 15 and 12, sectionValueAt() the values themselves. PULLED: of segments
// only one is there; APART: others may touch it (one_segment.glsl). FILLED: there is material that was added
// (fill.glsl).

#include "field/shaders/bindings.glsl"
layout(std140, binding = kSceneBlock) uniform SceneBlock {
    mat4 worldFromVoxel;
    mat4 voxelFromWorld;
    ivec4 dims;      // xyz voxels, w sculpture view: 0 whole, 1 cut, 2 probe
    vec4 spacing;    // xyz mm, w step mm
    vec4 valueScale; // x scale, y offset, z 1 if whole numbers, w tolerance at the range's lower end
    vec4 range;      // xy displayed range, zw grey window
    vec4 sceneFlags; // x 1 if there is a segmentation, yzw 1 / dims
    vec4 limits; // x the greatest visible value: the displayed range's upper end, or beyond all values (MIP,
                 // X-ray); yz scale and offset of smoothed values, w tolerance at the upper end
};

#ifdef SMOOTHED
layout(binding = kSmoothedTexture) uniform sampler3D dataTexture;
layout(binding = kSectionTexture) uniform sampler3D sectionTexture; // the values themselves
vec2 dataScale() { return limits.yz; }
#else
layout(binding = kDataTexture) uniform sampler3D dataTexture;
vec2 dataScale() { return valueScale.xy; }
#endif
layout(binding = kSculptureTexture) uniform sampler3D sculptureTexture;
layout(binding = kSegmentationTexture) uniform sampler3D
    segmentationTexture; // r opaque segments, g translucent ones
layout(binding = kSegmentLabelsTexture) uniform usampler3D segmentLabels; // or one texel for all voxels

struct SceneSample {
    float value;      // in the volume's unit
    float sculpture;  // 0 untouched .. 1 cut away
    float dataInside; // > 0 where the value is visible, < 0 elsewhere; continuous, in the volume's unit
    float uncut;      // >= 0 on the visible side of the sculpture; continuous, 0.5 level at 0
};

#ifdef FILTER_STEPS // of a texture unit that is pretended (gl::pretendedFilterSteps())
vec3 textureFromVoxel(vec3 p) {
    return (round(p * float(FILTER_STEPS)) / float(FILTER_STEPS) + 0.5) * sceneFlags.yzw;
}
#else
vec3 textureFromVoxel(vec3 p) { return (p + 0.5) * sceneFlags.yzw; }
#endif

// The segment that a voxel belongs to, 0 none; of places outside the grid, that of the nearest voxel.
uint segmentOf(ivec3 voxel) {
    return texelFetch(segmentLabels, clamp(voxel, ivec3(0), textureSize(segmentLabels, 0) - 1), 0).r;
}

// Eight voxels around a place: the first of them, and where the place lies between that and the last.
struct LabelCell {
    ivec3 first;
    vec3 part;
    bool isInPool; // `first` is a texel of bricks, not a voxel of the scene
};

#include "field/shaders/fetched.glsl"

// What texels of the data stand for that has this scale and offset.
Meaning meaningOfData(vec2 scale) {
#ifdef SMOOTHED
    return Meaning(scale, false);
#else
    return Meaning(scale, valueScale.z > 0.5);
#endif
}

// Values are sampled in a voxel space of their own, of the scene's grid or of a finer level's.
#ifdef BRICKS
#include "field/shaders/bricks.glsl"
vec3 sampledFromVoxel(vec3 p) { return levelFromVoxel(p); }
vec3 sampledPerVoxel() { return levelScale.xyz; }
ivec3 sampledDims() { return levelDims.xyz; }
// A voxel of that grid, in steps of the scene: how far apart samples of the data need be.
float fineStep() { return levelScale.w; }
#else
vec3 sampledFromVoxel(vec3 p) { return p; }
vec3 sampledPerVoxel() { return vec3(1.0); }
ivec3 sampledDims() { return dims.xyz; }
float fineStep() { return 1.0; }
#endif

// A voxel of the grid that segments are sampled in, in steps of the scene.
#ifdef FINER_SEGMENTS
float segmentStep() { return fineStep(); }
#else
float segmentStep() { return 1.0; }
#endif

#ifdef FILLED
#include "field/shaders/fill.glsl"
#endif

#include "field/shaders/quads.glsl"
// Stored values, and, fetched, what they stand for.
#if defined(BRICKS)
float storedAt(vec3 q) { return levelValueAt(q); }
float fetchedAt(vec3 q) { return fetchedLevelValueAt(q); }
vec2 storedScale() { return vec2(1.0, 0.0); }
#else
float fetchedAt(vec3 q) { return fetchedOfAll(dataTexture, q, dims.xyz, meaningOfData(dataScale())); }
vec2 storedScale() { return dataScale(); }
#endif
#if defined(QUADS) && !defined(BRICKS)
#ifdef SMOOTHED
layout(binding = kSmoothedQuadsTexture) uniform samplerBuffer quads;
#else
layout(binding = kQuadsTexture) uniform samplerBuffer quads;
#endif
float storedAt(vec3 q) { return ofQuads(quads, q); }
#elif !defined(BRICKS)
float storedAt(vec3 q) { return textureLod(dataTexture, textureFromVoxel(q), 0.0).r; }
#endif

// The scan's value at p.
#ifdef TRICUBIC
#include "field/shaders/tricubic.glsl"
#else
float scanAt(vec3 p) { return storedAt(sampledFromVoxel(p)) * storedScale().x + storedScale().y; }
// The same value wherever in a texture it is kept, for where it is close to one that decides something.
float exactScanAt(vec3 p) { return fetchedAt(sampledFromVoxel(p)); }
#endif

// The value at p, of the scan or of material.
#ifdef FILLED
float dataAt(vec3 p) { return orMaterial(scanAt(p), p); }
float exactDataAt(vec3 p) { return orMaterial(exactScanAt(p), p); }
#else
float dataAt(vec3 p) { return scanAt(p); }
float exactDataAt(vec3 p) { return exactScanAt(p); }
#endif

#ifdef SMOOTHED
#include "field/shaders/sections.glsl"
#else
// What a section through p shows: the scan's own value.
float sectionValueAt(vec3 p) { return scanAt(p); }
#endif

// The scan's stored value of one voxel, exact.
float scanValue(ivec3 v) {
    float value = texelFetch(dataTexture, v, 0).r * dataScale().x + dataScale().y;
    return valueScale.z > 0.5 ? round(value) : value;
}

// The value of one voxel, of the scan or of material.
#ifdef FILLED
float voxelValue(ivec3 v) { return orMaterial(scanValue(v), vec3(v)); }
#else
float voxelValue(ivec3 v) { return scanValue(v); }
#endif

#ifdef FINER_CUTS
float sculptureAt(vec3 p) { return levelSculptureAt(sampledFromVoxel(p)); }
float exactSculptureAt(vec3 p) { return fetchedLevelSculptureAt(sampledFromVoxel(p)); }
#else
float sculptureAt(vec3 p) { return textureLod(sculptureTexture, textureFromVoxel(p), 0.0).r; }
float exactSculptureAt(vec3 p) { return fetchedOfAll(sculptureTexture, p, dims.xyz, kThemselves); }
#endif

#ifdef PULLED
uniform ivec2 pulled; // x the label of that segment; y 0 if it is opaque, 1 if it is translucent
#endif

// How much p belongs to opaque segments (x) and to translucent ones (y); surfaces are at 0.5.
#if defined(PULLED) && defined(APART)
#include "field/shaders/one_segment.glsl"
vec2 membershipsAt(vec3 p) {
    float own = ownMembershipAt(p);
    return pulled.y == 0 ? vec2(own, 0.0) : vec2(0.0, own);
}
#elif defined(FINER_SEGMENTS)
vec2 membershipsAt(vec3 p) { return levelMembershipsAt(sampledFromVoxel(p)); }
#else
vec2 membershipsAt(vec3 p) { return textureLod(segmentationTexture, textureFromVoxel(p), 0.0).rg; }
#endif

#ifdef ALL_SEGMENTS
float segmentationAt(vec3 p) {
    vec2 memberships = membershipsAt(p);
    return max(memberships.x, memberships.y);
}
#else
float segmentationAt(vec3 p) { return membershipsAt(p).x; }
#endif

// >= 0 where the data may be seen beside translucent segments: about a voxel away from them. They rarely
// begin to the voxel where the data would be seen, and a crust of it would hide them.
float clearOfGlass(vec2 memberships) { return 0.16 - memberships.y; }

// >= 0 where a transfer function's data may be seen beside segments of any kind, likewise.
float clearOfSegments(vec2 memberships) { return 0.16 - max(memberships.x, memberships.y); }

float translucentAt(vec3 p) { return membershipsAt(p).y; }

// The labels of the segments around p: at a corner of the cell, whose `offset` is 0 or 1 along each axis.
#ifdef FINER_SEGMENTS
LabelCell labelCellAt(vec3 p) { return levelLabelCell(sampledFromVoxel(p)); }
uint labelAt(LabelCell cell, ivec3 offset) { return levelLabelAt(cell, offset); }
#else
LabelCell labelCellAt(vec3 p) { return LabelCell(ivec3(floor(p)), p - floor(p), false); }
uint labelAt(LabelCell cell, ivec3 offset) { return segmentOf(cell.first + offset); }
#endif

// How far a value is inside what is visible of the values: the displayed range, without an upper end where
// limits.x says so.
float insideRange(float value) { return min(value - range.x + valueScale.w, limits.x - value + limits.w); }

// Cut view shows sculpture < 0.5, probe view >= 0.5.
float visibleSide(float sculpture) {
    return dims.w == 0 ? 1.0 : (dims.w == 1 ? 0.5 - sculpture - 1e-6 : sculpture - 0.5);
}

#ifdef FILLED
// The same for what is at a place that is filled so much (filledAt()): material hides what the scan has
// there, and is seen itself. Of two functions that are >= 0 in parts of space the greater is so in both
// parts.
float withFill(float side, vec2 filled) { return max(min(side, 0.5 - filled.x), filled.y - 0.5); }
#endif

SceneSample sampleScene(vec3 p) {
    SceneSample s;
    s.value = dataAt(p);
    s.sculpture = sculptureAt(p);
    s.dataInside = insideRange(s.value);
    s.uncut = visibleSide(s.sculpture);
#ifdef FILLED
    s.uncut = withFill(s.uncut, filledAt(p));
#endif
    return s;
}

bool isVisible(SceneSample s) { return s.dataInside >= 0.0 && s.uncut >= 0.0; }

// Gradient in value per mm along the patient's axes (world), from central differences one voxel wide; with
// TRICUBIC the data's own derivative.
vec3 worldGradient(vec3 voxelGradient) { return transpose(mat3(voxelFromWorld)) * voxelGradient; }

// One voxel before p along each axis, but not beyond the grid's box, where textures are mirrored.
vec3 placesBefore(vec3 p) { return max(p - 1.0, vec3(-0.5)); }

// Defines the gradient of `valueAt` by central differences. A macro, because functions of GLSL take no
// functions.
#define DEFINE_GRADIENT(gradientAt, valueAt)                                                                 \
    vec3 gradientAt(vec3 p) {                                                                                \
        vec3 before = placesBefore(p);                                                                       \
        vec3 after = p + 1.0;                                                                                \
        return worldGradient(0.5 *                                                                           \
                             vec3(valueAt(vec3(after.x, p.yz)) - valueAt(vec3(before.x, p.yz)),              \
                                  valueAt(vec3(p.x, after.y, p.z)) - valueAt(vec3(p.x, before.y, p.z)),      \
                                  valueAt(vec3(p.xy, after.z)) - valueAt(vec3(p.xy, before.z))));            \
    }

#ifdef BRICKS
// The gradient of a `valueAt` that takes places of the level that is sampled, over a voxel of that.
#define DEFINE_FINER_GRADIENT(gradientAt, valueAt)                                                           \
    vec3 gradientAt(vec3 p) {                                                                                \
        vec3 q = sampledFromVoxel(p);                                                                        \
        vec3 before = placesBefore(q);                                                                       \
        vec3 after = q + 1.0;                                                                                \
        return worldGradient(0.5 * sampledPerVoxel() *                                                       \
                             vec3(valueAt(vec3(after.x, q.yz)) - valueAt(vec3(before.x, q.yz)),              \
                                  valueAt(vec3(q.x, after.y, q.z)) - valueAt(vec3(q.x, before.y, q.z)),      \
                                  valueAt(vec3(q.xy, after.z)) - valueAt(vec3(q.xy, before.z))));            \
    }
#endif

#ifdef TRICUBIC
vec3 dataGradient(vec3 p) { return worldGradient(voxelGradientAt(p)); }
#elif defined(BRICKS)
DEFINE_FINER_GRADIENT(dataGradient, storedAt)
#else
DEFINE_GRADIENT(dataGradient, scanAt)
#endif
#ifdef FINER_CUTS
DEFINE_FINER_GRADIENT(sculptureGradient, levelSculptureAt)
#else
DEFINE_GRADIENT(sculptureGradient, sculptureAt)
#endif
#if defined(FINER_SEGMENTS) && !(defined(PULLED) && defined(APART))
#ifdef ALL_SEGMENTS
float levelSegmentationAt(vec3 q) {
    vec2 memberships = levelMembershipsAt(q);
    return max(memberships.x, memberships.y);
}
#else
float levelSegmentationAt(vec3 q) { return levelMembershipsAt(q).x; }
#endif
float levelTranslucentAt(vec3 q) { return levelMembershipsAt(q).y; }
DEFINE_FINER_GRADIENT(segmentationGradient, levelSegmentationAt)
DEFINE_FINER_GRADIENT(translucentGradient, levelTranslucentAt)
#else
DEFINE_GRADIENT(segmentationGradient, segmentationAt)
DEFINE_GRADIENT(translucentGradient, translucentAt)
#endif
