//! The charts of a tile: flat coordinates about its centre, in radii, y the height over the plane.
//!
//! A point is `(cosh(y) P, sinh(y))` with P = (X, Z, W) on the plane's sheet `W^2 - X^2 - Z^2 = 1`: out along the plane to P,
//! then straight up by y. So `y = asinh(Y)`, and what is left of (X, Z, W) over `cosh(y) = sqrt(1 + Y^2)` is P.

use glam::{DVec3, DVec4};

/// The point (X, Y, Z, W) at (xi, y, eta) of the equiangular chart, in which `tanh(xi) = X/W` and `tanh(eta) = Z/W`; `None`
/// where `sinh(xi)^2 sinh(eta)^2 >= 1`: no point of the plane has these.
///
/// P is a multiple of (tanh xi, tanh eta, 1), so of `Q = (sinh xi cosh eta, cosh xi sinh eta, cosh xi cosh eta)`, and
/// `W^2 - X^2 - Z^2` of Q is `cosh^2 eta - cosh^2 xi sinh^2 eta = 1 - sinh^2 xi sinh^2 eta`: over its root Q is P.
///
/// At an edge xi is [`APOTHEM`](super::APOTHEM) all along, and eta is the same number in the frames of both tiles, since a
/// step along x leaves Z as it is and W too where `X/W` is that of the edge.
pub fn equiangular_point(chart: DVec3) -> Option<DVec4> {
    let (sinh_xi, cosh_xi) = (chart.x.sinh(), chart.x.cosh());
    let (sinh_eta, cosh_eta) = (chart.z.sinh(), chart.z.cosh());
    let both = sinh_xi * sinh_eta;
    let square = (1.0 - both) * (1.0 + both);
    // Not so of a NaN either.
    if square > 0.0 {
        let scale = chart.y.cosh() / square.sqrt();
        Some(DVec4::new(
            scale * sinh_xi * cosh_eta,
            chart.y.sinh(),
            scale * cosh_xi * sinh_eta,
            scale * cosh_xi * cosh_eta,
        ))
    } else {
        None
    }
}

/// Where a point (X, Y, Z, W) of the space is in the equiangular chart: (xi, y, eta). All have their place.
pub fn equiangular_chart(point: DVec4) -> DVec3 {
    DVec3::new(
        (point.x / point.w).atanh(),
        point.y.asinh(),
        (point.z / point.w).atanh(),
    )
}

/// Where a point (X, Y, Z, W) of the space is in the cylindrical chart about the tile's centre, the inverse of
/// [`charts::cylindrical`](crate::charts::cylindrical) of sign -1.
///
/// There (x, z) is in the direction of (X, Z), as long as the way r along the plane: `sinh(r) = |(X, Z)|/cosh(y)`.
pub fn cylindrical_chart(point: DVec4) -> DVec3 {
    let cosh_y = 1.0f64.hypot(point.y);
    let sinh_r = point.x.hypot(point.z) / cosh_y;
    let scale = if sinh_r > 0.0 {
        sinh_r.asinh() / (sinh_r * cosh_y)
    } else {
        1.0 / cosh_y
    };
    DVec3::new(point.x * scale, point.y.asinh(), point.z * scale)
}
