// Draws one layer of voxels (render::SliceRenderer, which says what is seen).
// SCULPTED: the sculpture hides some. SEGMENTED: there are segments. TINTED: what the 3D picture shows is
// coloured: by the transfer function where there is a TF_KIND, else in one tint.
// BRICKS: values are those of a finer level. FINER: see cast_rays.comp. FINER_CUTS, FINER_SEGMENTS: what is
// cut and what belongs to segments is, too. MARKS, FILLED: see there.
// Spaces: the slice runs through voxel centres of the scene, so of a place's cell only four corners count;
// they are asked for once, and everything is interpolated from them: corner 0 is the cell's first, 1 across,
// 2 down, 3 both. Of a finer level's cell, too, of which it may run between two layers of voxels.
//
// In: the scene, segment colours. Out: image 0.
// variants: ;SCULPTED=1 SEGMENTED=1 TINTED=1;BRICKS=1 FINER=1 SCULPTED=1 FINER_CUTS=1;BRICKS=1 FINER=1 SEGMENTED=1 FINER_SEGMENTS=1;BRICKS=1 FINER=1 SCULPTED=1 SEGMENTED=1 FINER_CUTS=1 FINER_SEGMENTS=2;SCULPTED=1 SEGMENTED=1 TINTED=1 MARKS=1;BRICKS=1 FINER=1 SCULPTED=1 SEGMENTED=1 FINER_CUTS=1 FINER_SEGMENTS=2 MARKS=1;SCULPTED=1 SEGMENTED=1 TINTED=1 MARKS=1 FILLED=2;FILLED=1;BRICKS=1 FINER=1 SCULPTED=1 SEGMENTED=1 FINER_CUTS=1 FINER_SEGMENTS=2 MARKS=1 FILLED=1
layout(local_size_x = 8, local_size_y = 8) in;

#include "field/shaders/bindings.glsl"
#include "render/shaders/bindings.glsl"
#include "field/shaders/scene.glsl"
#ifdef TF_KIND
#include "render/shaders/classification.glsl"
#include "render/shaders/gradients.glsl"
#endif
#include "render/shaders/shading.glsl"
#ifdef SEGMENTED
#include "render/shaders/segment_colours.glsl"
#endif
#ifdef MARKS
#include "field/shaders/marks.glsl"
#endif

layout(binding = kSlicePictureImage, rgba8) uniform writeonly image2D picture;

uniform vec3 first;    // voxel space: the first pixel's centre
uniform vec3 perRight; // per pixel
uniform vec3 perDown;
uniform ivec3 across; // unit steps within the slice
uniform ivec3 down;
uniform int isSmooth;
uniform vec2 window; // the values that are black and white
#if defined(TINTED) && !defined(TF_KIND)
uniform vec2 visible; // the values that are tinted: from, to
#endif
uniform vec2 segmentLook; // opacity of insides, width of outlines in pixels

const vec3 kOutside = vec3(0.043, 0.051, 0.059);

struct Cell {
    ivec3 corners[4];
    vec3 beside; // from these to the slice
    vec4 weights;
    int nearest;         // which corner
    vec2 part;           // where in the cell, 0 to 1 across and down
    vec2 pixelsPerVoxel; // how fast part changes: pixels for a voxel across, down
    mat2 partPerPixel;   // columns: per pixel to the right, down
};

// Of a grid of so many voxels, whose steps are the scene's times `scale`; p is a place in it.
Cell cellIn(vec3 p, vec3 scale, ivec3 voxels) {
    Cell cell;
    ivec3 normal = 1 - across - down;
    ivec3 base = ivec3(floor(p + vec3(normal) * 0.5)); // along the slice's normal: the nearest
    vec3 offset = p - vec3(base);
    cell.part = vec2(dot(offset, vec3(across)), dot(offset, vec3(down)));
    ivec3 last = voxels - 1;
    vec3 inside = clamp(p, vec3(0.0), vec3(last));
    cell.beside = (inside - vec3(clamp(base, ivec3(0), last))) * vec3(normal);
    cell.corners[0] = clamp(base, ivec3(0), last);
    cell.corners[1] = clamp(base + across, ivec3(0), last);
    cell.corners[2] = clamp(base + down, ivec3(0), last);
    cell.corners[3] = clamp(base + across + down, ivec3(0), last);
    vec2 f = cell.part;
    cell.weights = vec4((1.0 - f.x) * (1.0 - f.y), f.x * (1.0 - f.y), (1.0 - f.x) * f.y, f.x * f.y);
    cell.nearest = (f.x >= 0.5 ? 1 : 0) + (f.y >= 0.5 ? 2 : 0);
    vec3 right = perRight * scale;
    vec3 below = perDown * scale;
    cell.partPerPixel = mat2(dot(right, vec3(across)), dot(right, vec3(down)), dot(below, vec3(across)),
                             dot(below, vec3(down)));
    mat2 t = transpose(cell.partPerPixel);
    cell.pixelsPerVoxel = 1.0 / vec2(length(t[0]), length(t[1]));
    return cell;
}

Cell cellAt(vec3 p) { return cellIn(p, vec3(1.0), dims.xyz); }

#ifdef BRICKS
Cell finerCellAt(vec3 p) { return cellIn(sampledFromVoxel(p), sampledPerVoxel(), sampledDims()); }

// Where in the level the slice goes by a corner; that voxel itself where voxels are areas.
vec3 besideCorner(Cell cell, int i) {
    return vec3(cell.corners[i]) + (isSmooth != 0 ? cell.beside : vec3(0.0));
}
#endif

// Of values at the corners: what is at the place.
float blend(Cell cell, vec4 values) {
    return isSmooth != 0 ? dot(cell.weights, values) : values[cell.nearest];
}

// How many pixels a place lies inside the 0.5 level of what the corners hold; negative outside. Far: 1e3.
float pixelsInside(Cell cell, vec4 values) {
    if (isSmooth != 0) {
        vec2 gradient = vec2(mix(values.y - values.x, values.w - values.z, cell.part.y),
                             mix(values.z - values.x, values.w - values.y, cell.part.x));
        float slope = length(gradient * cell.partPerPixel);
        return clamp((dot(cell.weights, values) - 0.5) / max(slope, 1e-6), -1e3, 1e3);
    }
    // Voxels are areas: the nearest border to one that is on the other side.
    bvec4 inside = greaterThanEqual(values, vec4(0.5));
    bool here = inside[cell.nearest];
    vec2 apart = abs(cell.part - 0.5) * cell.pixelsPerVoxel;
    float pixels = inside[cell.nearest ^ 3] != here ? length(apart) : 1e3;
    pixels = inside[cell.nearest ^ 1] != here ? min(pixels, apart.x) : pixels;
    pixels = inside[cell.nearest ^ 2] != here ? min(pixels, apart.y) : pixels;
    return here ? pixels : -pixels;
}

#ifdef BRICKS
float finerValueAt(vec3 p, Cell finer) {
    return levelValueAt(isSmooth != 0 ? sampledFromVoxel(p) : vec3(finer.corners[finer.nearest]));
}
#else
vec4 valuesAround(Cell cell) {
    return vec4(scanValue(cell.corners[0]), scanValue(cell.corners[1]), scanValue(cell.corners[2]),
                scanValue(cell.corners[3]));
}

float valueAt(Cell cell) { return blend(cell, valuesAround(cell)); }
#endif

float greyAt(float value) {
    float t = window.y > window.x ? (value - window.x) / (window.y - window.x) : step(window.x, value);
    return clamp(t, 0.0, 1.0);
}

#if !defined(TINTED)
vec3 valueColour(float value, vec3 p) { return vec3(greyAt(value)); }
#elif defined(TF_KIND)
// What the function makes visible in its colours.
vec3 valueColour(float value, vec3 p) {
#if TF_KIND == 0
    vec4 c = classify(value, 0.0);
#else
    vec4 c = classify(value, gradientAt(p));
#endif
    float shown = clamp(c.a / lightingOfFunction.z, 0.0, 1.0);
    return mix(vec3(greyAt(value)), displayFromLinear(c.rgb), shown);
}
#else
// The tint is darker where the value is, so that what it lies on is read through it.
vec3 valueColour(float value, vec3 p) {
    const vec3 kTint = vec3(1.0, 0.62, 0.12);
    float grey = greyAt(value);
    bool isVisible = value >= visible.x && value <= visible.y;
    return isVisible ? mix(vec3(grey), kTint * mix(0.3, 1.0, grey), 0.6) : vec3(grey);
}
#endif

#ifdef SCULPTED
// What is on the hidden side of the sculpture: dark, under a hatch that no scan has, behind a crisp edge.
vec3 hideCut(vec3 colour, Cell cell, ivec2 pixel) {
    vec4 cut;
    for (int i = 0; i < 4; ++i) {
#ifdef FINER_CUTS
        float value = levelSculptureAt(besideCorner(cell, i));
#else
        float value = texelFetch(sculptureTexture, cell.corners[i], 0).r;
#endif
        cut[i] = dims.w == 1 ? value : 1.0 - value;
    }
    float inside = pixelsInside(cell, cut);
    float hidden = clamp(inside + 0.5, 0.0, 1.0);
    float hatch = (pixel.x + pixel.y) % 8 < 1 ? 0.10 : 0.0;
    vec3 dark = 0.22 * colour + vec3(0.02, 0.03, 0.04) + hatch;
    float edge = clamp(1.5 - abs(inside), 0.0, 1.0);
    return mix(mix(colour, dark, hidden), vec3(0.62, 0.70, 0.78), 0.5 * edge);
}
#endif

#ifdef FILLED
// Material over what is there: its value as the scan's would be shown, in a tint of its own behind a crisp
// edge.
vec3 coverByFill(vec3 colour, Cell cell, vec3 p) {
    vec4 any;
    for (int i = 0; i < 4; ++i) {
        any[i] = filledAt(vec3(cell.corners[i])).x;
    }
    float inside = pixelsInside(cell, any);
    bool isNear = inside > -1.0;
    while (isNear) {
        uint material = materialAt(isSmooth != 0 ? p : vec3(cell.corners[cell.nearest]), true);
        vec4 entry = materials[material];
        vec3 own = displayFromLinear(entry.rgb);
        float seen = isSeen(material) ? 1.0 : 0.4;
        vec3 shown = mix(valueColour(entry.w, p), own, 0.45 * seen);
        float covered = isSmooth != 0 ? clamp(inside + 0.5, 0.0, 1.0) : step(0.0, inside);
        float edge = covered * clamp(1.5 - inside, 0.0, 1.0);
        colour = mix(mix(colour, shown, covered), own, edge * seen);
        isNear = false;
    }
    return colour;
}
#endif

#ifdef SEGMENTED
#ifdef FINER_SEGMENTS
// How much a corner belongs to any segment, and which one has it.
struct Owner {
    float membership;
    uint label;
};

Owner ownerAt(LabelCell around, ivec3 offset) {
    vec4 texel = texelFetch(brickSegments, around.isInPool ? around.first + offset : ivec3(0), 0);
    vec2 both = membershipsOf(texel);
    Owner owner = Owner(max(both.x, both.y), labelOf(texel));
    bool isOfScene = !around.isInPool;
    while (isOfScene) {
        ivec3 voxel = clamp(around.first + offset, ivec3(0), dims.xyz - 1);
        both = texelFetch(segmentationTexture, voxel, 0).rg;
        owner = Owner(max(both.x, both.y), segmentOf(voxel));
        isOfScene = false;
    }
    return owner;
}

// What is in one of the two layers that the slice runs between is seen: no thin segment is lost in their
// mean.
Owner ownerOfCorner(Cell cell, int i) {
    LabelCell around = levelLabelCell(besideCorner(cell, i));
    ivec3 normal = 1 - across - down;
    ivec3 nearer = ivec3(floor(around.part + 0.5)) * normal;
    Owner owner = ownerAt(around, nearer);
    Owner other = ownerAt(around, normal - nearer);
    bool isBetween = dot(around.part, vec3(normal)) > 1e-3;
    return isBetween && other.membership > owner.membership ? other : owner;
}

float membershipOfCorner(Cell cell, int i) { return ownerOfCorner(cell, i).membership; }
uint labelOfCorner(Cell cell, int i) { return ownerOfCorner(cell, i).label; }
#else
float membershipOfCorner(Cell cell, int i) {
    vec2 both = texelFetch(segmentationTexture, cell.corners[i], 0).rg;
    return max(both.x, both.y);
}
uint labelOfCorner(Cell cell, int i) { return segmentOf(cell.corners[i]); }
#endif

// One segment over what is below: how much the corners belong to it is in `memberships`.
void coverBy(inout vec3 colour, Cell cell, vec4 memberships, vec4 entry) {
    float inside = pixelsInside(cell, memberships);
    float covered = isSmooth != 0 ? clamp(inside + 0.5, 0.0, 1.0) : step(0.0, inside);
    float outline = covered * clamp(segmentLook.y + 0.5 - inside, 0.0, 1.0);
    float opacity = mix(covered * segmentLook.x * entry.a, max(entry.a, 0.5), outline);
    colour = mix(colour, displayFromLinear(entry.rgb), opacity);
}

// The next corner after i that is of a segment no corner before it is of; 4 if there is none.
int nextSegment(uvec4 labels, int i) {
    bool isNew;
    do {
        ++i;
        isNew = i < 4 && labels[i & 3] != 0u;
        for (int j = 0; j < i; ++j) {
            isNew = isNew && labels[j & 3] != labels[i & 3];
        }
    } while (!isNew && i < 4);
    return i;
}

// Loops that need not be entered are what a software renderer saves time by; it goes both ways of every
// branch.
void coverBySegments(inout vec3 colour, Cell cell) {
    vec4 memberships;
    for (int i = 0; i < 4; ++i) {
        memberships[i] = membershipOfCorner(cell, i);
    }
    // Outside of all, and in what is hidden, nothing is anyone's.
    int count = any(greaterThanEqual(memberships, vec4(0.5))) ? 4 : 0;
    uvec4 labels = uvec4(0u);
    for (int i = 0; i < count; ++i) {
        labels[i] = memberships[i] >= 0.5 ? labelOfCorner(cell, i) : 0u;
        // What goes on behind a cut for the picture's sake (segment/membership/continuation.h) has not grown.
        memberships[i] = labels[i] == 0u ? min(memberships[i], 1.0 - memberships[i]) : memberships[i];
    }
    for (int i = count == 0 ? 4 : nextSegment(labels, -1); i < 4; i = nextSegment(labels, i)) {
        // What another segment has is not this one's; outside of all the smooth border of both goes on.
        vec4 own = mix(vec4(0.0), memberships, equal(labels, uvec4(labels[i])));
        own = mix(own, memberships, equal(labels, uvec4(0u)));
        coverBy(colour, cell, own, entryOf(labels[i]));
    }
}
#endif

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, imageSize(picture)))) {
        return;
    }
    vec3 p = first + float(pixel.x) * perRight + float(pixel.y) * perDown;
    vec3 colour = kOutside;
    if (all(greaterThanEqual(p, vec3(-0.5))) && all(lessThan(p, vec3(dims.xyz) - 0.5))) {
        Cell cell = cellAt(p);
#ifdef BRICKS
        Cell finer = finerCellAt(p);
        colour = valueColour(finerValueAt(p, finer), p);
#else
        colour = valueColour(valueAt(cell), p);
#endif
#ifdef FINER_CUTS
        colour = hideCut(colour, finer, pixel);
#elif defined(SCULPTED)
        colour = hideCut(colour, cell, pixel);
#endif
#ifdef FILLED
        colour = coverByFill(colour, cell, p);
#endif
#ifdef FINER_SEGMENTS
        coverBySegments(colour, finer);
#elif defined(SEGMENTED)
        coverBySegments(colour, cell);
#endif
#ifdef MARKS
        vec4 mark = markAt(p, length(perRight * spacing.xyz) / spacing.w);
        colour = mix(colour, displayFromLinear(mark.rgb), mark.a);
#endif
    }
    imageStore(picture, pixel, vec4(colour, 1.0));
}
