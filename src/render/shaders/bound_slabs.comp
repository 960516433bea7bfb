// Bounds of the values in every slab of every beam (slabs.glsl), so that in MIP a ray visits the best first, and then only those
// that may hold more.
// In: the scene and the view, texture 8 beams, texture 12 the greatest values in boxes of macrocells (widen_tops.comp).
// Out: image 0 (r32ui) words of slabs.
layout(local_size_x = 8, local_size_y = 4) in;

#include "field/shaders/scene.glsl"
#include "render/shaders/rays.glsl"
#include "render/shaders/beam.glsl"
#include "render/shaders/slabs.glsl"

layout(binding = 8) uniform sampler2D beams;
layout(binding = 12) uniform usampler3D cellTops;
layout(r32ui, binding = 0) uniform uimage2D words;

layout(location = 0) uniform int beamPixels; // side of a square
layout(location = 1) uniform float dt;       // steps between samples

// Each invocation's own: no other reads it.
const int kBuckets = 32;
shared uint places[32][kBuckets];
shared uint order[32][kOrderWords];

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

// Words of the beam's bounds; how many there are in each bucket.
void boundWords(ivec2 square, Slabs slabs, Beam beam) {
    int slab = 0;
    do {
        uint word = 0u;
        int i = 0;
        do {
            float t = (slabs.first + float(slab * slabs.samples) + 0.5) * dt;
            uint code = topBetween(beam, t, t + float(slabs.samples - 1) * dt);
            word |= slab < slabs.count ? code << (8 * i) : 0u;
            ++slab;
            ++i;
        } while (i < 4);
        imageStore(words, placeOfWord(square, kOrderWords + slab / 4 - 1), uvec4(word));
        places[gl_LocalInvocationIndex][bucketOf(greatestCode(word))] += 1u;
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

void orderWords(ivec2 square, Slabs slabs) {
    int word = 0;
    do {
        uint bucket = bucketOf(greatestCode(imageLoad(words, placeOfWord(square, kOrderWords + word)).r));
        uint place = places[gl_LocalInvocationIndex][bucket];
        places[gl_LocalInvocationIndex][bucket] = place + 1u;
        order[gl_LocalInvocationIndex][place / 4u] |= uint(word) << (8u * (place & 3u));
        ++word;
    } while (word < wordCount(slabs));
    for (int i = 0; i < kOrderWords; ++i) {
        imageStore(words, placeOfWord(square, i), uvec4(order[gl_LocalInvocationIndex][i]));
    }
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
    for (int i = 0; i < kOrderWords; ++i) {
        order[gl_LocalInvocationIndex][i] = 0u;
    }
    boundWords(square, slabs, beam);
    placeBuckets();
    orderWords(square, slabs);
}
