// All rays through a square of pixels: at t they lie within `reach + t * spread` (voxels, each axis) of the
// central one. Include "render/shaders/rays.glsl" first.
struct Beam {
    Ray central;
    vec3 reach;
    vec3 spread;
};

Beam beamThrough(vec2 lower, vec2 upper) {
    Beam beam;
    beam.central = rayThrough(0.5 * (lower + upper));
    // Directions are normalised, so the corners are not quite the extremes.
    beam.reach = vec3(0.02);
    beam.spread = vec3(0.0);
    vec3 reach = vec3(0.0);
    for (int corner = 0; corner < 4; ++corner) {
        Ray ray =
            rayThrough(vec2((corner & 1) == 0 ? lower.x : upper.x, (corner & 2) == 0 ? lower.y : upper.y));
        reach = max(reach, abs(ray.origin - beam.central.origin));
        beam.spread = max(beam.spread, abs(ray.direction - beam.central.direction));
    }
    beam.reach += reach;
    return beam;
}
