// What of the volume is left for tools after a change of the sculpture from `before` to what it is:
// sculpt::Trimmed.
// variants: SCULPTURE_BITS=16
// In: textures 0 sculpture, 1 what it was in the box, of a trim. In and out: image 0 what is left for tools.
layout(local_size_x = 8, local_size_y = 4, local_size_z = 2) in;

#include "gl/shaders/place.glsl"

#include "sculpt/shaders/bindings.glsl"
layout(binding = kWholeSculptureTexture) uniform sampler3D sculpture;
layout(binding = kBeforeTexture) uniform sampler3D before; // its first texel is `first`
#include "sculpt/shaders/stored_values.glsl"

layout(SCULPTURE_FORMAT, binding = kLeftForToolsImage) uniform image3D leftForTools;

uniform ivec3 first;
uniform ivec3 last; // exclusive
uniform int isTrim;
uniform int isNew; // only everything is left for tools

// What a cut leaves: where it is seen, of that nothing is.
float leftBy(float cut) { return cut < 0.5 ? asStored(1.0 - cut) : min(asStored(1.0 - cut), justVisible); }

void main() {
    ivec3 voxel = first + placeOfInvocation();
    if (any(greaterThanEqual(voxel, last))) {
        return;
    }
    if (isNew != 0) {
        imageStore(leftForTools, voxel, vec4(1.0));
        return;
    }
    float now = texelFetch(sculpture, voxel, 0).r;
    float earlier = isTrim != 0 ? texelFetch(before, voxel - first, 0).r : now;
    float left = imageLoad(leftForTools, voxel).r;
    if (now > earlier) {
        float byTools = left > leftBy(earlier) ? earlier : 0.0;
        left = min(left, max(byTools, leftBy(now)));
    }
    imageStore(leftForTools, voxel, vec4(max(left, leftBy(now))));
}
