// The first visible surface along a ray: what is seen, picked and cut.
// CONTENT chooses what counts as content: 0 data in the displayed range, 1 segmentation, 2 either of the two,
// 3 what the transfer function makes opaque enough to be touched. Include "render/shaders/rays.glsl" first,
// for 3 also "render/shaders/classification.glsl". SEGMENTS: with CONTENT 3, or the surface of a segment.
// TRANSLUCENT: some segments are translucent: nothing of the data is seen in them. CUT_ALONG_SEGMENTS (with
// SCULPTED): tools spared segments, or took nothing but them. WITHIN_SEGMENTS: nothing is seen outside of
// segments.

#include "render/shaders/content.glsl"

struct Hit {
    bool found;
    float t;     // steps along the ray
    vec3 voxel;  // where
    vec3 normal; // world, unit, facing the viewer
    bool isCut;  // on a cut face: the sculpture's 0.5 level, or the grid's border
    // How much is seen of a cut face there: all of it on one, some where the surface begins a hair behind
    // one. Pockets in a face end so shallow that a ray more or less would make a speck of them.
    float cutShare;
    vec3 cutNormal; // of that face: world, unit, facing the viewer
    bool isSegment;
    vec3 inSegment; // where that segment is
    bool isFill;    // of material that was added
};

#ifdef FILLED
DEFINE_GRADIENT(fillGradient, filledBySeen)
DEFINE_GRADIENT(anyFillGradient, filledByAny)
#endif

#ifdef SCULPTED
// Between two places of which neither is visible, content may begin before the visible side ends, or the side
// begin before the content ends: a sliver thinner than a step, along the edge of a cut. Where it is, as a
// part of the way; -1: nowhere. x content, y side, as in partsOfSurface, taken as linear between the
// places, and so far off at the most.
float sliverBetween(vec2 before, vec2 after, vec2 off) {
    vec2 crossing = before / (before - after);
    vec2 offThere = off / abs(before - after);
    bool contentBegins = before.x < 0.0 && after.x >= -off.x && before.y >= -off.y && after.y < 0.0;
    bool sideBegins = before.x >= -off.x && after.x < 0.0 && before.y < 0.0 && after.y >= -off.y;
    float late = crossing.x - crossing.y;
    float most = offThere.x + offThere.y;
    bool isThere = (contentBegins && late <= most) || (sideBegins && -late <= most);
    return isThere ? clamp(0.5 * (crossing.x + crossing.y), 0.0, 1.0) : -1.0;
}
#endif

// Where a ray first meets something visible: `t`, the visibility there, and `before`, a place without.
// Nothing when t is not below the ray's tEnd.
struct Crossing {
    float before;
    float t;
    float value;
};

const int kBatch = 8; // samples a turn: on a software renderer the turn itself costs as much as four of them

// Looks at the samples of one turn, from crossing.t on, and moves t to the first that is visible, or past
// those that are not. `last` is the visibility's parts (content, side) at the sample before them.
void testBatch(Ray ray, inout Crossing crossing, inout vec2 last) {
    float first = float(kBatch);
    vec2 found = vec2(-1.0);
    bool isBehindSliver = false;
#ifdef SCULPTED
    vec2 before = last;
    for (int i = 0; i < kBatch; ++i) {
        vec3 p = at(ray, crossing.t + float(i) * kDt);
        vec2 here = partsOfSurface(p);
        bool mayHoldSliver = sliverBetween(before, here, slack()) >= 0.0;
        bool mayBeSeen = all(greaterThanEqual(here, -slack()));
        bool isFirst = first == float(kBatch) && (mayBeSeen || mayHoldSliver);
        first = isFirst ? float(i) : first;
        found = isFirst ? here : found;
        isBehindSliver = isFirst ? mayHoldSliver : isBehindSliver;
        before = here;
    }
    last = before;
#else
    for (int i = kBatch - 1; i >= 0; --i) {
        vec3 p = at(ray, crossing.t + float(i) * kDt);
        vec2 here = partsOfSurface(p);
        bool mayBeSeen = all(greaterThanEqual(here, -slack()));
        first = mayBeSeen ? float(i) : first;
        found = mayBeSeen ? here : found;
    }
#endif
    crossing.t += first * kDt;
    crossing.value = min(found.x, found.y);
    // Whether a ray that grazes a surface meets it must not hang on where in a texture the values are kept.
    bool isClose = first < float(kBatch) && (isBehindSliver || any(lessThanEqual(abs(found), slack())));
    while (isClose) {
        vec2 here = exactPartsAt(at(ray, crossing.t));
        crossing.value = min(here.x, here.y);
        bool isPassed = crossing.value < 0.0;
        last = isPassed ? here : last;
        float further = isPassed ? 1.0 : 0.0;
#ifdef SCULPTED
        bool isWithin = crossing.t - kDt >= ray.tNear;
        vec2 earlier = isWithin ? exactPartsAt(at(ray, crossing.t - kDt)) : here;
        float sliver = sliverBetween(earlier, here, vec2(0.0));
        vec2 inSliver = exactPartsAt(at(ray, crossing.t + (sliver - 1.0) * kDt));
        bool isInSliver = sliver >= 0.0 && min(inSliver.x, inSliver.y) >= 0.0;
        crossing.value = isInSliver ? min(inSliver.x, inSliver.y) : crossing.value;
        further = isInSliver ? sliver - 1.0 : further;
#endif
        crossing.t += further * kDt;
        isClose = false;
    }
}

// Looks at every sample that may be visible; shading comes after it. Loops end with their condition: a
// software renderer runs a body to its end when no ray is left in it.
Crossing firstVisible(Ray ray, float jitter) {
    vec3 inverseDirection = safeInverse(ray.direction);
    Crossing crossing;
    crossing.t = nextSample(ray.tBegin, kDt, jitter);
    crossing.value = -1.0;
    vec2 last = vec2(-1.0);
    do {
        float start = crossing.t;
        float skip;
        do {
            skip = noSurfaceUntil(ray, crossing.t, inverseDirection);
            crossing.t = skip > 0.0 ? nextSample(crossing.t + skip, kDt, jitter) : crossing.t;
        } while (skip > 0.0 && crossing.t < ray.tEnd);
#ifdef SCULPTED
        // A sliver may lie between the last empty sample and the first that is not.
        bool hasSkipped = crossing.t > start;
        last = hasSkipped ? vec2(-1.0) : last;
        crossing.t -= hasSkipped && crossing.t - kDt >= ray.tNear ? kDt : 0.0;
#endif
        testBatch(ray, crossing, last);
    } while (crossing.value < 0.0 && crossing.t < ray.tEnd);
    // The sample before: of a sliver it is nearer than a whole distance of samples.
    const float hair = 1e-3;
    float number = ceil(crossing.t / kDt - jitter - hair) - 1.0;
    crossing.before = max((number + jitter) * kDt, ray.tNear);
    return crossing;
}

// What keeps a place from being seen: x the content, y the sculpture's side; a part that does not, 0.
struct Obstacle {
    bool isAbove; // the value is above what is visible, not below
    vec2 weight;
};

// Content and side at p as far as they are in the way there.
vec2 partsAt(vec3 p, bool isAbove) {
#if CONTENT == 0
    float value = exactScanAt(p);
    float inside = isAbove ? limits.x - value + limits.w : value - range.x + valueScale.w;
#ifdef FILL_IS_CONTENT
    inside /= rangeWidth();
#endif
    return withMaterial(p, vec2(inside, exactCutSideAt(p)));
#else
    return exactPartsAt(p);
#endif
}

Obstacle obstacleAt(vec3 p) {
    Obstacle obstacle;
#if CONTENT == 0 || CONTENT == 2
    obstacle.isAbove = exactScanAt(p) > limits.x;
#else
    obstacle.isAbove = false;
#endif
    vec2 parts = partsAt(p, obstacle.isAbove);
    obstacle.weight = mix(vec2(0.0), -1.0 / parts, lessThan(parts, vec2(0.0)));
    return obstacle;
}

// -1 where the obstacle was found, 0 where it ends, and about straight between: what else bounds the visible,
// and would bend it, is left out.
float beyond(Obstacle obstacle, vec3 p) {
    vec2 parts = partsAt(p, obstacle.isAbove) * obstacle.weight;
    return obstacle.weight.x == 0.0 ? parts.y : obstacle.weight.y == 0.0 ? parts.x : min(parts.x, parts.y);
}

// Whether what ends at p, where an obstacle has been left behind, is the sculpture's hidden side: of two that
// end within a step, the one that ends last is what the surface is made of.
bool endsAtCut(Obstacle obstacle, vec3 p) {
    vec2 parts = partsAt(p, obstacle.isAbove) * obstacle.weight;
    return obstacle.weight.y != 0.0 && (obstacle.weight.x == 0.0 || parts.y <= parts.x);
}

// The zero between an invisible place a and a visible one b, given a third place c close by (x place, y what
// is beyond there): by inverse quadratic interpolation, or linearly where that leads out of the interval or
// where two of the three are so much alike that their difference may be a coarse filter's.
float zeroBetween(vec2 a, vec2 b, vec2 c) {
    float linear = mix(a.x, b.x, a.y / (a.y - b.y));
    vec3 differences = vec3(a.y - b.y, b.y - c.y, c.y - a.y);
    float quadratic = -(a.x * b.y * c.y * differences.y + b.x * a.y * c.y * differences.z +
                        c.x * a.y * b.y * differences.x) /
                      (differences.x * differences.y * differences.z);
    bool isApart = min(abs(differences.y), abs(differences.z)) > 0.2 * abs(differences.x);
    return isApart && quadratic >= a.x && quadratic <= b.x ? quadratic : linear;
}

// Moves a crossing back to the surface: an invisible place just before it, and the surface. Two more samples,
// kept off the ends of what they divide so that a jump (the edge of non-finite voxels) is closed in on too.
vec2 refine(Ray ray, Crossing crossing, Obstacle obstacle) {
    if (obstacle.weight == vec2(0.0)) {
        return vec2(crossing.before); // visible from the start: the ray enters the box inside
    }
    vec2 outside = vec2(crossing.before, -1.0);
    vec2 inside = vec2(crossing.t, max(beyond(obstacle, at(ray, crossing.t)), 0.0)); // see slack()
    float guess = mix(outside.x, inside.x, outside.y / (outside.y - inside.y));
    for (int i = 0; i < 2; ++i) {
        float margin = 0.05 * (inside.x - outside.x);
        float place = clamp(guess, outside.x + margin, inside.x - margin);
        vec2 there = vec2(place, beyond(obstacle, at(ray, place)));
        bool seen = there.y >= 0.0;
        vec2 replaced = seen ? inside : outside;
        inside = seen ? there : inside;
        outside = seen ? outside : there;
        guess = zeroBetween(outside, inside, replaced);
    }
    return vec2(outside.x, guess);
}

// Normal of the box face that the point is nearest to, facing out.
vec3 boxNormal(vec3 p) {
    vec3 centred = (p - 0.5 * vec3(dims.xyz - 1)) / (0.5 * vec3(dims.xyz));
    vec3 a = abs(centred);
    vec3 n = a.x >= a.y && a.x >= a.z ? vec3(sign(centred.x), 0.0, 0.0)
             : a.y >= a.z             ? vec3(0.0, sign(centred.y), 0.0)
                                      : vec3(0.0, 0.0, sign(centred.z));
    return normalize(transpose(mat3(voxelFromWorld)) * n);
}

// A direction of zero length stays harmless: seen face on.
vec3 facing(vec3 gradient, vec3 towardsViewer) {
    float l = length(gradient);
    vec3 n = l > 1e-12 ? gradient / l : towardsViewer;
    return dot(n, towardsViewer) < 0.0 ? -n : n;
}

// A unit normal from a vector that points out of what has been met. Gradients are taken over two voxels and
// may disagree with what the ray met: by little where it grazes the surface, which is then seen edge on, or
// wholly at a wall so thin that its far side outweighs the near one, which is parallel to it. From the one to
// the other without a jump, or rounding would decide it.
vec3 outwards(vec3 outward, vec3 towardsViewer) {
    const float grazing = 0.1; // cosines: edge on up to here,
    const float behind = 0.7;  // and turned over from here on
    float l = length(outward);
    vec3 n = l > 1e-12 ? outward / l : towardsViewer;
    float c = dot(n, towardsViewer);
    vec3 edgeOn = (n - c * towardsViewer) * inversesqrt(max(1.0 - c * c, 1e-6));
    float fromViewer = mix(acos(0.0), -acos(clamp(-c, 0.0, 1.0)), smoothstep(grazing, behind, -c));
    return c >= 0.0 ? n : cos(fromViewer) * towardsViewer + sin(fromViewer) * edgeOn;
}

#if defined(CUT_ALONG_SEGMENTS) && defined(MEETS_SEGMENTS)
// Whether a cut face is a segment's own surface, because a tool spared the segment or took nothing else:
// there membership is a half but for rounding to 8 bits and for texture units, which know 256 places from one
// texel to the next, and both face the same way.
bool isSegmentsSurface(vec3 p, vec3 cutOutward) {
    const float rounding = 0.04;
    bool isClose = abs(segmentationAt(p) - 0.5) < rounding;
    vec3 inward = segmentationGradient(p);
    float lengths = length(inward) * length(cutOutward); // zero where no cut is near
    return isClose && dot(inward, cutOutward) < -0.7 * lengths;
}
#endif

// `jitter` in [0, 1) shifts the samples by that part of a step: what they all miss then differs from ray to
// ray.
Hit findSurface(Ray ray, float jitter) {
    Hit hit;
    Crossing crossing = firstVisible(ray, jitter);
    hit.t = crossing.t;
    hit.found = hit.t < ray.tEnd;
    hit.isCut = false;
    hit.isSegment = false;
    hit.normal = -ray.world;
    hit.voxel = vec3(0.0);
    hit.inSegment = vec3(0.0);
    hit.isFill = false;
    hit.cutShare = 0.0;
    hit.cutNormal = hit.normal;
    if (!hit.found) {
        return hit;
    }
    Obstacle obstacle = obstacleAt(at(ray, crossing.before));
    vec2 bracket = refine(ray, crossing, obstacle);
    hit.t = bracket.y;
    hit.voxel = at(ray, hit.t);
#ifdef MEETS_SEGMENTS
    // The data's surface and the segment's rarely agree to the voxel: what lies just behind is tinted too.
    // Seeds lie up to a voxel behind the surface that they were drawn on.
    float nearby = segmentationAt(hit.voxel);
    hit.inSegment = hit.voxel;
#ifndef PULLED
    for (int i = 1; i <= 3; ++i) {
        vec3 behind = at(ray, hit.t + 0.5 * segmentStep() * float(i));
        float there = segmentationAt(behind);
        hit.inSegment = nearby < 0.5 && there >= 0.5 ? behind : hit.inSegment;
        nearby = max(nearby, there);
    }
#endif
#endif
#ifdef FILLED
    vec2 filled = filledAt(hit.voxel);
#endif
#ifdef FILL_IS_CONTENT
    float beside = min(min(exactContentAt(hit.voxel), exactCutSideAt(hit.voxel)), 0.5 - filled.x);
    hit.isFill = fillShown(hit.voxel, filled) > beside;
#endif
    bool atBorder = bracket.y - ray.tNear < 1e-3 && ray.tNear > 0.0;
    vec3 outward = dataGradient(hit.voxel) * (obstacle.isAbove ? 1.0 : -1.0);
#if CONTENT == 3
    outward = facing(outward, -ray.world); // a transfer function has no inside
#endif
#ifdef MEETS_SEGMENTS
    // Whichever of the two begins here: at its own surface each is zero but for rounding.
    bool isSegmentsOwn = CONTENT == 1 || segmentationAt(hit.voxel) - 0.5 >= exactDataShownAt(hit.voxel);
#if defined(TRANSLUCENT) && CONTENT != 3
    bool endsAtGlass = clearOfGlass(membershipsAt(hit.voxel)) <= partInside(exactScanAt(hit.voxel));
    outward = endsAtGlass ? translucentGradient(hit.voxel) : outward;
#endif
    outward = isSegmentsOwn ? -segmentationGradient(hit.voxel) : outward;
    hit.isSegment = isSegmentsOwn || nearby >= 0.5;
    hit.inSegment = isSegmentsOwn ? hit.voxel : hit.inSegment;
#endif
    hit.isCut = atBorder;
    bool isAlongSegment = false; // cut along a segment's own surface
#ifdef SCULPTED
    vec3 cutOutward = sculptureGradient(hit.voxel) * (dims.w == 1 ? 1.0 : -1.0);
#if defined(FILLED) && FILLED == 2
    // The face where material ends that is not seen itself.
    bool isBesideFill = 0.5 - filled.x < cutSideAt(hit.voxel);
    cutOutward = isBesideFill ? anyFillGradient(hit.voxel) : cutOutward;
#endif
#if defined(CUT_ALONG_SEGMENTS) && defined(MEETS_SEGMENTS)
    isAlongSegment = isSegmentsSurface(hit.voxel, cutOutward);
#endif
    if (endsAtCut(obstacle, hit.voxel) && !atBorder) {
        hit.isCut = true;
#ifdef MEETS_SEGMENTS
        // Segments go on behind a cut face (segment/membership/continuation.h), so that what is met on it is
        // exact.
        hit.isSegment = segmentationAt(hit.voxel) >= 0.5;
        hit.inSegment = hit.voxel;
#endif
        outward = cutOutward;
#if defined(CUT_ALONG_SEGMENTS) && defined(MEETS_SEGMENTS)
        // The segment was spared: what is seen is its surface, and no section.
        hit.isSegment = hit.isSegment || isAlongSegment;
        hit.isCut = !isAlongSegment;
        outward = isAlongSegment ? -segmentationGradient(hit.voxel) : outward;
#endif
    }
#endif
    hit.normal = outwards(atBorder ? boxNormal(hit.voxel) : outward, -ray.world);
    hit.cutNormal = hit.normal;
    hit.cutShare = hit.isCut ? 1.0 : 0.0;
#ifdef SCULPTED
    const float hair = 0.12; // of the sculpture: about a quarter of a voxel behind its 0.5 level
    hit.cutNormal = hit.isCut ? hit.normal : outwards(cutOutward, -ray.world);
    float sideOfFace = cutSideAt(hit.voxel);
#if defined(FILLED) && FILLED == 2
    sideOfFace = min(sideOfFace, 0.5 - (filled.x - filled.y));
#endif
    hit.cutShare = hit.isCut ? 1.0 : 1.0 - smoothstep(0.0, hair, sideOfFace);
    hit.cutShare = dims.w == 0 || isAlongSegment ? 0.0 : hit.cutShare;
#endif
#ifdef FILL_IS_CONTENT
    if (hit.isFill) {
        hit.isCut = false;
        hit.isSegment = false;
        hit.cutShare = 0.0;
        hit.normal = outwards(atBorder ? boxNormal(hit.voxel) : -fillGradient(hit.voxel), -ray.world);
    }
#endif
    return hit;
}
