// How much a place belongs to one segment alone, where others may touch it (PULLED with APART): what it would
// be if the others were hidden. What is kept for that is one byte a voxel for all segments; where that does
// not tell, because more than two meet, each one's part is estimated by whose voxels are next to it.
//
// Bindings: texture 7 (segment::Segmentation::apart): in a voxel that is a segment's, twice what that segment
// has there beyond 128 of 255, plus 1 where it does not tell what others have; in a voxel that is nobody's, 1
// where several segments have something. Included by scene.glsl; declare `corners` before.

layout(binding = kApartTexture) uniform sampler3D apartTexture;

float bytesOf(float texel) { return round(255.0 * texel); }

// How much is there of all segments of the one's kind, opaque or translucent; in 255ths, as all that follows.
float ofKindAt(ivec3 voxel) {
    vec2 all = texelFetch(segmentationTexture, voxel, 0).rg;
    return bytesOf(pulled.y == 0 ? all.r : all.g);
}

uint ownerOf(ivec3 voxel) { return texelFetch(segmentLabels, voxel, 0).r; }

// Of what segments other than its owner's have in a voxel, the one's part, by whose voxels are next to it.
// Not if not `wanted`. (A loop over all that smoothing reaches would be exact. On Mesa's software renderer
// all loops of a ray end after 65,536 turns together.)
float partOfOthers(ivec3 voxel, uint owner, bool wanted) {
    int reach = wanted ? 1 : -1;
    float ofOne = 0.0;
    float ofAll = 1e-6;
    for (int z = -reach; z <= reach; ++z) {
        for (int y = -reach; y <= reach; ++y) {
            for (int x = -1; x <= 1; ++x) {
                ivec3 other = clamp(voxel + ivec3(x, y, z), ivec3(0), dims.xyz - 1);
                uint there = ownerOf(other);
                bool counts = there != owner && there != 0u && ofKindAt(other) >= 128.0;
                float weight = counts ? exp(-0.5 * float(x * x + y * y + z * z)) : 0.0;
                ofAll += weight;
                ofOne += there == uint(pulled.x) ? weight : 0.0;
            }
        }
    }
    return ofOne / ofAll;
}

// At a voxel's centre.
float ownMembershipOf(ivec3 voxel) {
    const float belowHalf = 127.0;
    vec2 both = texelFetch(segmentationTexture, voxel, 0).rg;
    float ofKind = ofKindAt(voxel);
    float kept = bytesOf(texelFetch(apartTexture, voxel, 0).r);
    float ofOwner = 128.0 + floor(0.5 * kept);
    uint owner = ownerOf(voxel);
    bool isOwnVoxel = owner == uint(pulled.x) && ofKind >= 128.0;
    bool isNobodys = max(both.r, both.g) < 0.5;
    bool isAnothers = !isNobodys && ofKind >= 128.0 && owner != 0u && !isOwnVoxel;
#ifdef WITHIN_SEGMENTS
    const bool isUnsure = false; // rays that go through do not show where exactly it ends
#else
    bool isUnsure = fract(0.5 * kept) > 0.25 && ofKind > 0.0 && (isNobodys || isAnothers);
#endif
    float own = isOwnVoxel ? ofOwner : isAnothers ? clamp(ofKind - ofOwner, 0.0, belowHalf) : ofKind;
    float part = partOfOthers(voxel, isNobodys ? 0u : owner, isUnsure);
    return (isUnsure ? part * own : own) / 255.0;
}

// The voxel that a texture shows at a place of its grid or a little outside, where it is mirrored.
ivec3 mirrored(ivec3 voxel) {
    ivec3 inside = mix(voxel, -1 - voxel, lessThan(voxel, ivec3(0)));
    return min(inside, 2 * dims.xyz - 1 - inside);
}

// Whether the segment can have a half or more at p: only close to a voxel of its own. (Behind a cut
// nothing is seen.)
bool mayBeOwn(vec3 p) {
    ivec3 first = ivec3(floor(p));
    bool isNear = false;
    for (int corner = 0; corner < corners; ++corner) {
        uint owner = ownerOf(mirrored(first + ivec3(corner & 1, (corner >> 1) & 1, corner >> 2)));
        isNear = isNear || owner == uint(pulled.x);
    }
    return isNear;
}

// 0 if not `wanted`.
float ownMembershipAt(vec3 p, bool wanted) {
    vec3 first = floor(p);
    vec3 f = p - first;
    float sum = 0.0;
    int count = wanted ? corners : 0;
    for (int corner = 0; corner < count; ++corner) {
        ivec3 offset = ivec3(corner & 1, (corner >> 1) & 1, corner >> 2);
        vec3 w = mix(1.0 - f, f, vec3(offset));
        sum += w.x * w.y * w.z * ownMembershipOf(mirrored(ivec3(first) + offset));
    }
    return sum;
}
