//! Double-double arithmetic against the committed 80-digit numbers.
#![allow(clippy::unwrap_used, reason = "tests fail by panicking")]

use antipode_lab::double_double::Double2;
use serde_json::Value;

#[test]
fn rounded_once_it_gives_the_eighty_digit_numbers_exactly() {
    let text = include_str!("../../../tests/reference/geometry.json");
    let golden: Value = serde_json::from_str(text).unwrap();
    let rows = golden["scalars"].as_array().unwrap();
    assert!(rows.len() >= 5);
    let half = Double2::from(0.5);
    for row in rows {
        let number = |name: &str| row[name].as_f64().unwrap();
        let t = Double2::from(number("t"));
        let ((sin, cos), (sinh, cosh)) = (t.sin_cos(), t.sinh_cosh());
        assert_eq!((sin / t).to_f64(), number("sinc"), "{row}");
        assert_eq!((sinh / t).to_f64(), number("sinhc"), "{row}");
        // (cos t - 1)/t^2 = -(sin(t/2)/t)^2 * 2, which does not cancel.
        let two = Double2::from(2.0);
        let (sin_half, _) = (t * half).sin_cos();
        let (sinh_half, _) = (t * half).sinh_cosh();
        let bend = |s: Double2| (two * (s / t) * (s / t)).to_f64();
        assert_eq!(-bend(sin_half), number("cos_bend"), "{row}");
        assert_eq!(bend(sinh_half), number("cosh_bend"), "{row}");
        assert!((cosh - cos).to_f64() >= 0.0, "{row}");
    }
}
