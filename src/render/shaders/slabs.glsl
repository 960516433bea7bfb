// Slabs of beams: pieces of all rays of a square of pixels, each with a bound of the values that they can
// meet in it (MIP). Samples lie at (k + 0.5) * dt; a slab holds `samples` of them, from `first` on. A bound
// is a code of one byte. Lists of slabs (r16ui, texture 11), kEntriesOfBeam for each beam: of each that may
// show something the number times 256 plus the code, those with the greatest bounds first, as far as
// bucketOf() tells them apart; then 0. Include "field/shaders/scene.glsl" first.

const int kMostSlabs = 192; // in a beam
const int kEntriesOfBeam = kMostSlabs + 1;
const int kSlabBatch = 8; // samples in a slab, or a multiple of that for a long beam

uniform int beamsAcross;

struct Slabs {
    float first; // number of the first sample
    int count;
    int samples;
};

Slabs slabsAlong(vec2 ends, float dt) {
    Slabs slabs;
    slabs.first = floor(ends.x / dt - 0.5);
    float samples = min(max(ceil(ends.y / dt - slabs.first), 0.0), 1e6);
    slabs.samples = kSlabBatch * max(int(ceil(samples / float(kSlabBatch * kMostSlabs))), 1);
    slabs.count = min(int(ceil(samples / float(slabs.samples))), kMostSlabs);
    return slabs;
}

int placeOfList(ivec2 beam) { return (beam.y * beamsAcross + beam.x) * kEntriesOfBeam; }

// Codes of values: finer for small ones, where noise would make many slabs look alike.
float rootInRange(float value) {
    float part = range.y > range.x ? (value - range.x) / (range.y - range.x) : 1.0;
    return sqrt(clamp(part, 0.0, 1.0));
}

// Never too small: 0 for nothing to see, 1 for the range's lower end, 255 for its upper.
uint codeOfBound(float bound) {
    const float hair = 0.01; // more than rounding may make of 253 steps
    float root = rootInRange(bound);
    uint code = root > 0.0 ? uint(min(1.0 + ceil(253.0 * root + hair), 255.0)) : 1u;
    return bound < range.x - 2.0 * valueScale.w ? 0u : code;
}

// What bounds must exceed to be of interest, once this value has been met. -1e30 for nothing yet.
uint codeOfGreatest(float value) {
    uint code = value >= range.y ? 255u : 1u + uint(253.0 * rootInRange(value));
    return value > -1e29 ? code : 0u;
}

// 0 for nothing to see.
uint bucketOf(uint code) { return (code + 7u) >> 3; }
