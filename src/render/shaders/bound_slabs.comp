// Bounds of the values in every slab of every beam (slabs.glsl), so that in MIP a ray visits the best first,
// and then only those that may hold more. In: the scene and the view, texture 8 beams, texture 12 the
// greatest values in boxes of macrocells (widen_tops.comp). Out: image 0 (r16ui) lists of slabs.
layout(local_size_x = 8, local_size_y = 4) in;

#include "field/shaders/scene.glsl"
#include "render/shaders/rays.glsl"
#include "render/shaders/beam.glsl"
#include "render/shaders/slabs.glsl"

#include "render/shaders/bindings.glsl"
layout(binding = kBeamsTexture) uniform sampler2D beams;
layout(binding = kCellTopsTexture) uniform usampler3D cellTops;
layout(r16ui, binding = kListsImage) uniform writeonly uimageBuffer lists;

uniform int beamPixels; // side of a square
uniform float dt;       // steps between samples

// Each invocation's own: no other reads it.
const int kBuckets = 33;
shared uint places[32][kBuckets];
shared uint codes[32][kMostSlabs / 4];

// The code of the greatest value that the beam can show from t0 to t1.
uint topBetween(Beam beam, float t0, float t1) {
    vec3 p0 = at(beam.central, t0);
    vec3 p1 = at(beam.central, t1);
    vec3 extent = beam.reach + t1 * beam.spread;
    ivec3 first = cellAt(min(p0, p1) - extent);
    ivec3 last = cellAt(max(p0, p1) + extent);
    // Boxes of two cells a side, at the end perhaps of one.
    ivec3 count = clamp((last - first) / 2 + 1, ivec3(1), textureSize(cellDistances, 0));
    int left = count.x * count.y * count.z;
    ivec3 i = ivec3(0);
    uint top = 0u;
    do {
        ivec3 cell = min(first + 2 * i, last);
        ivec3 isWide = ivec3(lessThan(cell, last));
        uint codes = texelFetch(cellTops, cell * ivec3(1, 1, 2) + ivec3(0, 0, isWide.z), 0).r;
        top = max(top, (codes >> (8 * isWide.x + 16 * isWide.y)) & 0xffu);
        --left;
        i.x += 1;
        i.y += i.x == count.x ? 1 : 0;
        i.x = i.x == count.x ? 0 : i.x;
        i.z += i.y == count.y ? 1 : 0;
        i.y = i.y == count.y ? 0 : i.y;
    } while (left > 0);
    return top;
}

// The slabs' codes, four in a word; how many there are in each bucket.
void boundSlabs(Slabs slabs, Beam beam) {
    int slab = 0;
    uint word = 0u;
    do {
        float t = (slabs.first + float(slab * slabs.samples) + 0.5) * dt;
        uint code = topBetween(beam, t, t + float(slabs.samples - 1) * dt);
        code = slab < slabs.count ? code : 0u;
        int byte = slab & 3;
        word = (byte == 0 ? 0u : word) | code << (8 * byte);
        codes[gl_LocalInvocationIndex][slab >> 2] = word;
        places[gl_LocalInvocationIndex][bucketOf(code)] += 1u;
        ++slab;
    } while (slab < slabs.count);
}

// Counts become the places where each bucket begins, the highest bucket first.
void placeBuckets() {
    uint place = 0u;
    int bucket = kBuckets - 1;
    do {
        uint count = places[gl_LocalInvocationIndex][bucket];
        places[gl_LocalInvocationIndex][bucket] = place;
        place += count;
        --bucket;
    } while (bucket >= 0);
}

void listSlabs(ivec2 square, Slabs slabs) {
    int list = placeOfList(square);
    int slab = 0;
    do {
        uint code = codes[gl_LocalInvocationIndex][slab >> 2] >> (8 * (slab & 3)) & 0xffu;
        uint place = places[gl_LocalInvocationIndex][bucketOf(code)];
        places[gl_LocalInvocationIndex][bucketOf(code)] = place + 1u;
        imageStore(lists, list + int(place), uvec4(uint(slab) << 8 | code));
        ++slab;
    } while (slab < slabs.count);
    imageStore(lists, list + slab, uvec4(0u));
}

void main() {
    ivec2 square = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(square, textureSize(beams, 0)))) {
        return;
    }
    vec2 lower = vec2(square * beamPixels);
    Beam beam = beamThrough(lower, min(lower + float(beamPixels), viewport.xy));
    Slabs slabs = slabsAlong(texelFetch(beams, square, 0).rg, dt);
    for (int i = 0; i < kBuckets; ++i) {
        places[gl_LocalInvocationIndex][i] = 0u;
    }
    boundSlabs(slabs, beam);
    placeBuckets();
    listSlabs(square, slabs);
}
