// Pre-integrates a transfer function over intensity: colour and opacity of a piece of a ray along which the value goes
// evenly from front to back (Engel, Kraus, Ertl 2001, "High-quality pre-integrated volume rendering using
// hardware-accelerated pixel shading"). Each piece is put together from eight parts, whose sums come from running integrals;
// within a part colours are weighted as if nothing hid anything.
// In: storage 0 running sums of extinction * colour and extinction (fixed point), texture 0 the function.
// Out: image 0 (rgba16f) x front, y back: premultiplied linear colour, opacity.
layout(local_size_x = 16, local_size_y = 4) in;

const int kParts = 8; // as many as finer texels lie between two of the table's, so that parts end on texels

layout(std430, binding = 0) readonly buffer Integrals { uvec4 integrals[]; };
layout(binding = 0) uniform sampler2D functionTable;
layout(rgba16f, binding = 0) uniform writeonly image2D segments;

layout(location = 0) uniform vec2 stepsAndQuantum; // steps of a segment; extinction that one unit of the sums means

float extinction(float opacity) { return -log(1.0 - min(opacity, 1.0 - 1e-6)); }

// Mean of extinction * colour (xyz) and extinction (w) from fine texel a to b.
vec4 meanBetween(int a, int b) {
    uvec4 sum = integrals[max(a, b)] - integrals[min(a, b)];
    return vec4(sum) * (stepsAndQuantum.y / float(max(abs(b - a), 1)));
}

void main() {
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(texel, imageSize(segments)))) {
        return;
    }
    int first = kParts * texel.x;
    int last = kParts * texel.y;
    vec4 result = vec4(0.0);
    if (first == last) {
        vec4 c = texelFetch(functionTable, ivec2(first, 0), 0);
        float opacity = 1.0 - exp(-extinction(c.a) * stepsAndQuantum.x);
        result = vec4(c.rgb, 1.0) * opacity;
    } else {
        int stride = texel.y - texel.x;
        for (int part = 0; part < kParts; ++part) {
            vec4 mean = meanBetween(first + part * stride, first + (part + 1) * stride);
            float opacity = 1.0 - exp(-mean.w * stepsAndQuantum.x / float(kParts));
            result += (1.0 - result.a) * opacity * vec4(mean.rgb / max(mean.w, 1e-20), 1.0);
        }
    }
    imageStore(segments, texel, result);
}
