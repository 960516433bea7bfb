// What segments are taken to be behind the cut faces that end them, so that a cut face has the colour of what
// it was cut through. Growth stops at the sculpture, so there it says nothing about the voxels that are
// hidden; see doc/segmentation.md. In a run that was fenced to what is visible now, a hidden voxel that has
// not grown counts as part of the segment if its rules let it in and its foot does: the visible voxel
// straight before it. Where the foot is none of it because the rules refuse that (a hole, or a border that
// widens behind the face), or another segment's, the voxels around it count, the fewer the deeper the voxel;
// where growth has only not come there yet, none. A foot that does not follow the rules goes on straight.
// What an edit has made is known, on either side of the face: it goes on only where it ends there. A run that
// was fenced to what is hidden now ends in front of the face as abruptly: its voxels there do not count. In:
// texture 0 data, 1 and 4 sculpture, 3 labels; storage 0 grown, 1 rules of each label, 2 shown, 3 and 4
// generations, 7 brick numbers. In and out: storage 6 the voxels that count as the opposite of what they are;
// 5 which tiles changes reach. With VS_GRADIENTS some rules ask for gradients, with VS_ALONE one segment
// is shown and no other. One row of 16 groups a brick, an invocation a word.
#include "segment/shaders/constraints.glsl"
#include "segment/shaders/words.glsl"
#include "segment/shaders/generations.glsl"
#include "segment/shaders/owners.glsl"
#include "segment/shaders/note_changes.glsl"
#include "segment/shaders/fences.glsl"

layout(local_size_x = 64) in;

const uint kFencedToVisible = 1u;
const uint kFencedToHidden = 2u;

struct Rules {
    vec4 voxel; // xy of intensity, zw of the gradient's magnitude
    vec4 pair;  // the same of their differences
    uvec4 run;  // x its fence, y the last generation that an edit has made
};

#include "segment/shaders/bindings.glsl"
layout(std430, binding = kGrownStorage) readonly buffer Grown { uint grown[]; };
layout(std430, binding = kRulesOfLabelsStorage) readonly buffer RulesOfLabels { Rules rules[]; };
layout(std430, binding = kShownBitsStorage) readonly buffer Shown { uint shown[]; };
layout(std430, binding = kTurnedBitsStorage) buffer Turned { uint turned[]; };
layout(std430, binding = kBricksStorage) readonly buffer Bricks { uint bricks[]; };

uniform int takesAway; // 1: some run is fenced to what is hidden
uniform ivec3 aside;   // voxels along each axis that are about as far as one across thick slices

const int kLayers = 3; // as far as a kernel sees

bool isGrown(ivec3 voxel) { return (grown[wordAt(wordPlaceOf(voxel))] >> bitOf(voxel) & 1u) != 0u; }
#ifdef VS_ALONE
uniform uint ownLabel;
bool isSeen(ivec3 voxel) { return ownerOf(voxel) == ownLabel; }
#else
bool isSeen(ivec3 voxel) { return true; }
#endif
bool isShown(ivec3 voxel) {
    return (shown[wordAt(wordPlaceOf(voxel))] >> bitOf(voxel) & 1u) != 0u && isSeen(voxel);
}

// Whether the rules let a voxel in by itself.
bool admits(Rules of, ivec3 voxel) {
    bool admitted = isWithin(valueOf(voxel), of.voxel.xy);
#ifdef VS_GRADIENTS
    admitted = admitted && isWithin(gradientMagnitude(voxel), of.voxel.zw);
#endif
    return admitted;
}

// And from another one, whether or not they are neighbours.
bool admitsFrom(Rules of, ivec3 parent, ivec3 child) {
    bool admitted = admits(of, child) && isWithin(valueOf(child) - valueOf(parent), of.pair.xy);
#ifdef VS_GRADIENTS
    admitted = admitted && isWithin(gradientMagnitude(child) - gradientMagnitude(parent), of.pair.zw);
#endif
    return admitted;
}

// Is an edit's, not growth's.
bool isMade(Rules of, ivec3 voxel) {
    return generationIn(wordAt(wordPlaceOf(voxel)), bitOf(voxel)) <= of.run.y;
}

float sculptureOf(ivec3 voxel) {
    return texelFetch(sculptureTexture, clamp(voxel, ivec3(0), gridDims - 1), 0).r;
}

// From a hidden voxel straight to the visible side: one voxel along the axis that it goes along most. Zero:
// nobody knows where.
vec3 towardsVisible(ivec3 v) {
    vec3 along = vec3(sculptureOf(v + ivec3(1, 0, 0)) - sculptureOf(v - ivec3(1, 0, 0)),
                      sculptureOf(v + ivec3(0, 1, 0)) - sculptureOf(v - ivec3(0, 1, 0)),
                      sculptureOf(v + ivec3(0, 0, 1)) - sculptureOf(v - ivec3(0, 0, 1)));
    along = hides == 1 ? -along : along;
    vec3 world = gradientAlongX * along.x + gradientAlongY * along.y + gradientAlongZ * along.z;
    vec3 way = vec3(dot(gradientAlongX, world), dot(gradientAlongY, world), dot(gradientAlongZ, world));
    vec3 size = abs(way);
    float most = max(size.x, max(size.y, size.z));
    return most > 0.0 ? way / most : vec3(0.0);
}

// The foot of a hidden voxel, and in w how many voxels away it is; 0: it is too far, or there is none.
ivec4 footOf(ivec3 voxel) {
    vec3 way = towardsVisible(voxel);
    int layer = 0;
    ivec3 foot = voxel;
    bool isFound = false;
    int layers = way == vec3(0.0) ? 0 : kLayers;
    while (layer < layers && !isFound) {
        ++layer;
        foot = voxel + ivec3(round(way * float(layer)));
        isFound = isInside(foot) && !isHidden(foot);
    }
    return ivec4(foot, isFound ? layer : 0);
}

ivec3 around(int i) { return ivec3(i % 3, i / 3 % 3, i / 9) - 1; }

// How much of what is visible around the foot of a hidden voxel, so many steps away, would take it in, by
// weight. A foot that has not grown must be something that the segment refuses: where growth has only not
// come yet it has not come behind either. Looks at nothing if not `wanted`.
float partAround(ivec3 voxel, ivec3 foot, int steps, bool footHasGrown, bool wanted) {
    float all = 0.0;
    float some = 0.0;
    for (int i = 0; i < (wanted ? 27 : 0); ++i) {
        ivec3 other = foot + around(i) * aside * steps;
        ivec3 weights = 2 - abs(around(i));
        float weight = isInside(other) && !isHidden(other) ? float(weights.x * weights.y * weights.z) : 0.0;
        bool takes = weight > 0.0 && isShown(other);
        if (takes) {
            Rules own = rules[ownerOf(other)];
            takes = own.run.x == kFencedToVisible && admitsFrom(own, other, voxel) && !isMade(own, other) &&
                    (footHasGrown || !admitsFrom(own, other, foot));
        }
        all += weight;
        some += takes ? weight : 0.0;
    }
    return some / max(all, 1.0);
}

// Whether nothing visible around a foot is shown. Looks at nothing if not `wanted`.
bool isBareAround(ivec3 foot, bool wanted) {
    bool isBare = true;
    for (int i = 0; i < (wanted ? 27 : 0) && isBare; ++i) {
        ivec3 other = foot + around(i);
        isBare = !(isInside(other) && isShown(other)) || isHidden(other);
    }
    return isBare;
}

// Whether something hidden next to a voxel is shown by itself.
bool isKnownBehind(ivec3 voxel, bool wanted) {
    bool isKnown = false;
    for (int i = 0; i < (wanted ? 27 : 0) && !isKnown; ++i) {
        ivec3 beside = voxel + around(i);
        isKnown = isInside(beside) && isShown(beside) && isHidden(beside);
    }
    return isKnown;
}

// Whether a hidden voxel that has not grown counts as part of a segment of this plane.
bool joins(ivec3 voxel, ivec3 foot, int layer) {
    bool footHasGrown = isGrown(foot);
    Rules own = rules[ownerOf(foot)];
    bool follows =
        footHasGrown && own.run.x == kFencedToVisible && (admitsFrom(own, foot, voxel) || !admits(own, foot));
    bool made = follows && isMade(own, foot);
    follows = follows && !(made && isKnownBehind(voxel, made));
    float enough = layer == 1 ? 0.1 : layer == 2 ? 0.05 : 0.02;
    // Behind another segment's foot the border between the two may run flat under the face, and be that much
    // farther away.
    const int farthest = 4;
    bool isBeside = false;
    for (int steps = 1; steps <= (footHasGrown ? farthest : 1) && !isBeside; steps *= 2) {
        isBeside = partAround(voxel, foot, steps, footHasGrown, !follows) >= enough;
    }
    return follows ? isShown(foot) : isBeside;
}

// Whether a hidden voxel that is shown does not count.
bool leaves(ivec3 voxel, ivec3 foot) {
    bool isFenced = rules[ownerOf(voxel)].run.x == kFencedToHidden;
    return isFenced && isBareAround(foot, isFenced);
}

bool isTurned(ivec3 voxel, bool grownHere) {
    bool is = false;
    ivec4 foot = isHidden(voxel) ? footOf(voxel) : ivec4(0);
    if (foot.w > 0) {
        is = grownHere ? leaves(voxel, foot.xyz) : joins(voxel, foot.xyz, foot.w);
    }
    return is;
}

// Of a word's voxels, those that may be close enough to shown ones behind a fence.
uint candidates(uint word, ivec3 place) {
    uint bits = insideGrid(place) & (~grown[word] | (takesAway != 0 ? shown[word] : 0u));
    ivec3 cell = ivec3(place.xy, place.z >> 1);
    bits = isFenceIn(cell - 1, cell + 1, bits != 0u) ? bits : 0u;
    uint near = 0u;
    for (int i = 0; i < (bits != 0u ? 45 : 0) && near == 0u; ++i) { // four voxels to each side
        near = shown[wordAt(place + ivec3(i % 3, i / 3 % 3, i / 9) - ivec3(1, 1, 2))];
    }
    return near != 0u ? bits : 0u;
}

void main() {
    uint word = bricks[uint(firstBrick) + gl_WorkGroupID.y] * kWordsPerBrick + gl_GlobalInvocationID.x;
    ivec3 place = placeOfWord(word);
    uint grownHere = grown[word];
    uint found = 0u;
    for (uint left = candidates(word, place); left != 0u; left &= left - 1u) {
        int bit = findLSB(left);
        found |= uint(isTurned(voxelAt(place, bit), (grownHere >> bit & 1u) != 0u)) << bit;
    }
    noteChanges(word, found ^ turned[word]);
    turned[word] = found;
}
