// The data as the cubic B-spline of its stored values (field::Sampling::Tricubic), not prefiltered, and its
// derivative. Each axis has four weights, those of two neighbours joined in one linearly filtered fetch
// between them: eight trilinear fetches stand for 64 voxels (Sigg and Hadwiger 2005, "Fast third-order
// texture filtering", GPU Gems 2, chapter 20). Voxel space. Beyond the grid values are those at its border.
// Included by scene.glsl.

// Where two neighbours are joined, along each axis, and with what weights.
struct Taps {
    vec3 lower;
    vec3 upper;
    vec3 weightLower;
    vec3 weightUpper;
};

// Values outside are those at the border, which a mirrored texture would not give.
vec3 tapAt(vec3 q) { return clamp(q, vec3(0.0), vec3(sampledDims() - 1)); }

Taps valueTaps(vec3 p) {
    vec3 first = floor(p);
    vec3 f = p - first;
    vec3 g = 1.0 - f;
    vec3 farthest = f * f * f / 6.0;                 // of voxel first + 2
    vec3 before = g * g * g / 6.0;                   // of voxel first - 1
    vec3 next = 2.0 / 3.0 - 0.5 * g * g * (2.0 - g); // of voxel first + 1
    Taps taps;
    taps.weightUpper = next + farthest;
    taps.weightLower = 1.0 - taps.weightUpper;
    taps.lower = tapAt(first - before / taps.weightLower);
    taps.upper = tapAt(first + 1.0 + farthest / taps.weightUpper);
    return taps;
}

// The derivatives of those weights; they are negative for the lower two voxels, positive for the upper two.
Taps slopeTaps(vec3 p) {
    vec3 first = floor(p);
    vec3 f = p - first;
    vec3 g = 1.0 - f;
    Taps taps;
    taps.weightUpper = 0.5 + f * g;
    taps.weightLower = -taps.weightUpper;
    taps.lower = tapAt(first - 0.5 * g * g / taps.weightUpper);
    taps.upper = tapAt(first + 1.0 + 0.5 * f * f / taps.weightUpper);
    return taps;
}

// `isExact`: wherever in a texture the values are kept (fetched.glsl).
float tap(float x, float y, float z, bool isExact) {
    return isExact ? fetchedAt(vec3(x, y, z)) : storedAt(vec3(x, y, z));
}

// Two of the eight fetches, along x.
float tapsAlongX(Taps t, float y, float z, bool isExact) {
    return t.weightLower.x * tap(t.lower.x, y, z, isExact) + t.weightUpper.x * tap(t.upper.x, y, z, isExact);
}

float tapsInPlane(Taps t, float z, bool isExact) {
    return t.weightLower.y * tapsAlongX(t, t.lower.y, z, isExact) +
           t.weightUpper.y * tapsAlongX(t, t.upper.y, z, isExact);
}

float eightTaps(Taps t, bool isExact) {
    return t.weightLower.z * tapsInPlane(t, t.lower.z, isExact) +
           t.weightUpper.z * tapsInPlane(t, t.upper.z, isExact);
}

// The taps of `values`, along one axis (a unit vector) those of `slopes`.
Taps tapsAlong(vec3 axis, Taps values, Taps slopes) {
    return Taps(mix(values.lower, slopes.lower, axis), mix(values.upper, slopes.upper, axis),
                mix(values.weightLower, slopes.weightLower, axis),
                mix(values.weightUpper, slopes.weightUpper, axis));
}

float scanAt(vec3 p) {
    return eightTaps(valueTaps(sampledFromVoxel(p)), false) * storedScale().x + storedScale().y;
}
float exactScanAt(vec3 p) { return eightTaps(valueTaps(sampledFromVoxel(p)), true); }

// Value per voxel along each axis.
vec3 voxelGradientAt(vec3 p) {
    vec3 q = sampledFromVoxel(p);
    Taps values = valueTaps(q);
    Taps slopes = slopeTaps(q);
    const vec3 e = vec3(1.0, 0.0, 0.0);
    return sampledPerVoxel() * storedScale().x *
           vec3(eightTaps(tapsAlong(e.xyy, values, slopes), false),
                eightTaps(tapsAlong(e.yxy, values, slopes), false),
                eightTaps(tapsAlong(e.yyx, values, slopes), false));
}
