// Functions of one number for shaders/geometry.wgsl, which comes behind: trigonometry by series.
//
// WGSL's own sin, cos, sinh, cosh, asinh and atan2 may be off by thousands of units in the last
// place, so series in t^2 take their places: only + - * are exact enough everywhere.
// crates/geometry/src/kernel/series.rs has the same functions.

const GEO_LOG2_E: f32 = 1.44269504;
const GEO_SQRT2: f32 = 1.41421356;
// ln 2 in two parts; a whole number up to 2^14 times the first is exact, fused or not.
const GEO_LN2_HIGH: f32 = 0.693359375;
const GEO_LN2_LOW: f32 = -2.12194440e-4;
// The series of sine and cosine end a little past a right angle, at this t^2: nearer it the half
// angle's rounding would count four times.
const GEO_OBTUSE: f32 = 3.2;
// The series below are least-squares fits at Chebyshev nodes in 60 digits, each coefficient rounded
// from the constant upwards and the rest fitted again; what the truncation leaves is under a tenth
// of an ulp. Errors are bounds in ulp of the result, arguments taken as exact; tests hold
// them over golden rows and a million arguments each on the adapter in use. They survive fusing and reassociation.

// (sin(t)/t - 1)/t^2 for s = t^2, t up to pi: 1.5 ulp.
fn geo_sin_bend(s: f32) -> f32 {
    return -1.66666672e-1 + s * (8.33334774e-3 + s * (-1.98424474e-4 + s * (2.75983484e-6
        + s * (-2.57442228e-8 + s * (2.162827e-10 + s * -2.45090753e-12)))));
}

// (sinh(t)/t - 1)/t^2 for s = t^2, t up to 2: 1.5 ulp.
fn geo_sinh_bend(s: f32) -> f32 {
    return 1.66666672e-1 + s * (8.33330862e-3 + s * (1.98447189e-4 + s * (2.73608339e-6
        + s * (2.99407006e-8 + s * -2.78099127e-10))));
}

// What (sin(t)/t, cos(t)) exceed 1 by, for s = t^2 from -1, where s < 0 stands for sinh and cosh, to
// GEO_OBTUSE: both to half an ulp of 1 before they are added to it, and no less exact near 0.
fn geo_sinc_cos_excess(s: f32) -> vec2<f32> {
    return vec2<f32>(
        s * (-1.66666672e-1 + s * (8.33333563e-3 + s * (-1.98408408e-4
            + s * (2.75160755e-6 + s * -2.37021176e-8)))),
        s * (-0.5 + s * (4.16666679e-2 + s * (-1.38888939e-3
            + s * (2.48005163e-5 + s * (-2.74755109e-7 + s * 1.90350358e-9))))),
    );
}

// (sin(t)/t, cos(t)) for s = t^2, t up to pi, and (sinh(t)/t, cosh(t)) for s = -t^2, t up to 1; past
// GEO_OBTUSE from the half angle, by sin t = 2 sin cos and cos t = 2 cos^2 - 1. The sine over t to
// 1.5 ulp up to a right angle, both to 1.5 ulp of 1 everywhere.
fn geo_sinc_cos(s: f32) -> vec2<f32> {
    let far = s > GEO_OBTUSE;
    let near = 1.0 + geo_sinc_cos_excess(select(s, 0.25 * s, far));
    return vec2<f32>(
        select(near.x, near.x * near.y, far),
        select(near.y, 2.0 * (near.y * near.y) - 1.0, far),
    );
}

// What the two of geo_sinc_cos exceed 1 by; no digit is lost near 0.
fn geo_excess(s: f32) -> vec2<f32> {
    let far = s > GEO_OBTUSE;
    let excess = geo_sinc_cos_excess(select(s, 0.25 * s, far));
    let near = 1.0 + excess;
    return vec2<f32>(
        select(excess.x, near.x * near.y - 1.0, far),
        select(excess.y, 2.0 * (near.y * near.y) - 2.0, far),
    );
}

// Half of exp(t + rest), 0 <= t < 88 and |rest| an ulp of t at most, as a power of two a, high and
// low: a (1 + (high + low)). High is what of t is left over the exponent, and exact. The series is
// (exp(x) - 1 - x)/x^2 on -0.4 ln(2) <= x <= 0.6 ln(2).
fn geo_half_exp_parts(t: f32, rest: f32) -> vec3<f32> {
    let n = floor(t * GEO_LOG2_E + 0.4);
    let high = t - n * GEO_LN2_HIGH;
    let low = n * GEO_LN2_LOW - rest;
    let x = high - low;
    let a = bitcast<f32>(u32(i32(n) + 126) << 23u);
    let p = 0.5 + x * (0.166666687 + x * (0.0416666009 + x * (0.00833224598
        + x * (0.00139144086 + x * 0.000209505859))));
    return vec3<f32>(a, high, x * (x * p) - low);
}

// The same, and half of exp(-t) in a: (a, high, low, fade); t >= 1.
fn geo_half_exp(t: f32, rest: f32) -> vec4<f32> {
    let e = geo_half_exp_parts(t, rest);
    return vec4<f32>(e, 0.25 / (e.x * (1.0 + (e.y + e.z))) / e.x);
}

// exp(t) for 0 <= t < 88: 1.2 ulp.
fn geo_exp(t: f32) -> f32 {
    let e = geo_half_exp_parts(t, 0.0);
    return 2.0 * e.x * (1.0 + (e.y + e.z));
}

// (sinh(t)/t, cosh(t)) for 1 <= t <= 81 from exponentials, the greatest part added last: 1.5 ulp.
// What is divided by t goes in two parts, the first of them short, so that no rounding is doubled by
// the quotient.
fn geo_sinhc_cosh_far(t: f32) -> vec2<f32> {
    let e = geo_half_exp(t, 0.0);
    let sine = e.z - e.w;
    let short = bitcast<f32>(bitcast<u32>(1.0 + (e.y + sine)) & 0xfffff000u);
    let left = ((1.0 - short) + e.y) + sine;
    return vec2<f32>(e.x * (short / t + left / t), e.x * (1.0 + (e.y + (e.z + e.w))));
}

// (sinh(t)/t, cosh(t)) for |t| <= 81: 1.5 ulp. Series to 1, where nothing cancels.
fn geo_sinhc_cosh(t: f32) -> vec2<f32> {
    let a = abs(t);
    if a < 1.0 {
        return geo_sinc_cos(-a * a);
    }
    return geo_sinhc_cosh_far(a);
}

// The length of a vector and what rounding took from it, to 2^-33 of the length: half of
// q.q - t^2 over t. Each coordinate and t are cut at one place, 11 bits from t's first; squares of
// what is before it add up without rounding in any order, fused or not. Lengths from 1e-15 to 1e18.
fn geo_length_rest(q: vec3<f32>) -> vec2<f32> {
    let t = sqrt(q.x * q.x + q.y * q.y + q.z * q.z);
    let exponent = bitcast<u32>(t) & 0x7f800000u;
    let unit = bitcast<f32>(exponent) * 0.0009765625;
    let per_unit = bitcast<f32>(0x7f000000u - exponent) * 1024.0;
    let v = vec4<f32>(q, t);
    let h = floor(v * per_unit + 0.5) * unit;
    let before = h.x * h.x + h.y * h.y + h.z * h.z - h.w * h.w;
    let b = (v - h) * (v + h);
    return vec2<f32>(t, (before + (b.x + b.y + b.z - b.w)) * (0.5 / t));
}

// Hyperbolic sine and cosine in parts, (scale, sine, cosine, divisor), for a length of 1 to 81 radii:
// sinc = scale (1 + sine) / divisor and cosine = scale (1 + cosine), scale a power of two. A product
// of two of them has one rounding, by geo_product, and not three.
fn geo_parts_far(q: vec3<f32>) -> vec4<f32> {
    let t = geo_length_rest(q);
    let e = geo_half_exp(t.x, t.y);
    // sinh/(t + rest) is sinh/t less its part rest/t.
    let sine = e.y + (e.z - e.w);
    return vec4<f32>(e.x, sine - (1.0 + sine) * (t.y / t.x), e.y + (e.z + e.w), t.x);
}

// (1 + x)(1 + y), scaled, with one rounding of the size of the answer.
fn geo_product(scale: f32, x: f32, y: f32) -> f32 {
    return scale + scale * (x + (y + x * y));
}

// The sine over its argument and the cosine of any curvature: `s` is kappa t^2, from -81^2 to pi^2.
// As geo_sinc_cos and geo_sinhc_cosh; past s = -1 the root adds t/2 ulp, the condition of exp.
fn geo_sine_cosine(s: f32) -> vec2<f32> {
    if s > -1.0 {
        return geo_sinc_cos(s);
    }
    return geo_sinhc_cosh_far(sqrt(-s));
}

// (sinc(t) - 1)/t^2 for t^2 = s, `flip` -1 for sin (t up to pi) and 1 for sinh (t up to 2): 1.5 ulp.
fn geo_sinc_bend(s: f32, flip: f32) -> f32 {
    return select(geo_sin_bend(s), geo_sinh_bend(min(s, 4.0)), flip > 0.0);
}

// atan2(s, c) for s >= 0: 1.5 ulp. The ratio of the lesser to the greater goes through the series,
// taken from 1/2 where it is more, and one sum adds what the octant begins with: a multiple of a
// right angle, atan(1/2) from it, and what rounding took from either. The series is
// (atan(x)/x - 1)/x^2 on |x| <= 1/2.
fn geo_angle(s: f32, c: f32) -> f32 {
    let low = min(s, abs(c));
    let high = max(s, abs(c));
    if high == 0.0 {
        return 0.0;
    }
    let half = low > 0.5 * high;
    let ratio = select(low, low - 0.5 * high, half) / select(high, high + 0.5 * low, half);
    let steep = s > abs(c);
    let back = c < 0.0;
    let right = select(vec2<f32>(0.0, 0.0), vec2<f32>(4.63647604e-1, 5.01215869e-9), half);
    let before = select(vec2<f32>(1.57079637, -4.37113883e-8),
        vec2<f32>(1.10714877, -4.87235496e-8), half);
    let behind = select(vec2<f32>(1.57079637, -4.37113883e-8),
        vec2<f32>(2.03444386, 8.05100555e-8), half);
    let left = select(vec2<f32>(3.14159274, -8.74227766e-8),
        vec2<f32>(2.67794514, -9.24349379e-8), half);
    let base = select(select(right, left, back), select(before, behind, back), steep);
    let x = select(-ratio, ratio, steep == back);
    let q = x * x;
    let p = -3.33333343e-1 + q * (1.99999914e-1 + q * (-1.42824337e-1 + q * (1.10311553e-1
        + q * (-8.33320022e-2 + q * 4.36842814e-2))));
    return base.x + (x + (x * (q * p) + base.y));
}

// asinh(x) for 0 <= x < 1e38: 1.5 ulp. Past 3/4 it is the logarithm of x + sqrt(x^2 + 1) = 2x + r,
// r = 1/(x + sqrt(x^2 + 1)): the mantissa of 2x less 1 is exact, and r is added to that small
// number, not to 2x. The series are (asinh(x)/x - 1)/x^2 on 0 <= x <= 3/4 and
// (log(1 + g) - g)/g^2 on sqrt(1/2) <= 1 + g <= sqrt(2).
fn geo_asinh(x: f32) -> f32 {
    if x < 0.75 {
        let s = x * x;
        let p = -1.66666672e-1 + s * (7.50002414e-2 + s * (-4.46450636e-2 + s * (3.03693246e-2
            + s * (-2.20891982e-2 + s * (1.5658088e-2 + s * (-8.84563942e-3
            + s * 2.66794907e-3))))));
        return x + x * (s * p);
    }
    let y = min(x, 1.0e4);
    let r = 1.0 / (y + sqrt(y * y + 1.0));
    // 2x + r over 2^n lies between sqrt(1/2) and sqrt(2).
    let n = i32(bitcast<u32>((x + 0.5 * r) * GEO_SQRT2) >> 23u) - 126;
    let scale = bitcast<f32>(u32(128 - n) << 23u);
    let g = (x * scale - 1.0) + 0.5 * (r * scale);
    let p = -4.99999911e-1 + g * (3.33333254e-1 + g * (-2.50014096e-1 + g * (2.00019225e-1
        + g * (-1.66123107e-1 + g * (1.41838819e-1 + g * (-1.32224888e-1 + g * (1.28881216e-1
        + g * -7.64790773e-2)))))));
    let m = f32(n);
    return m * GEO_LN2_HIGH + (g + (g * (g * p) + m * GEO_LN2_LOW));
}

// The length of any vector: out of the range of squares, in units of its greatest coordinate.
fn geo_length(v: vec3<f32>) -> f32 {
    let most = max(max(abs(v.x), abs(v.y)), abs(v.z));
    if most < GEO_SQUARABLE && most * GEO_SQUARABLE > 1.0 {
        return sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
    }
    if most == 0.0 {
        return 0.0;
    }
    let u = v / most;
    return most * sqrt(u.x * u.x + u.y * u.y + u.z * u.z);
}

