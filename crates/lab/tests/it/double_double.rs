//! Double-double arithmetic against the committed 80-digit numbers.

use antipode_lab::double_double::Double2;
use serde_json::Value;

/// The columns of the table: sign of the curvature, t, and then the sine over its argument, the sine, the
/// cosine and (cosine - 1)/t^2 that belong to the sign.
#[test]
fn rounded_once_it_gives_the_eighty_digit_numbers_exactly() {
    let text = include_str!("../../../../tests/reference/functions.json");
    let golden: Value = serde_json::from_str(text).unwrap();
    let rows = golden["data"]["scalar"].as_array().unwrap();
    let (half, two) = (Double2::from(0.5), Double2::from(2.0));
    let mut looked_at = 0;
    for row in rows {
        let number = |column: usize| row[column].as_f64().unwrap();
        let (sign, size) = (number(0), number(1));
        // Larger angles would need pi to more digits than the test is about.
        if sign == 0.0 || size > 20.0 {
            continue;
        }
        looked_at += 1;
        let t = Double2::from(size);
        let of = |t: Double2| {
            if sign > 0.0 {
                t.sin_cos()
            } else {
                t.sinh_cosh()
            }
        };
        let (sine, cosine) = of(t);
        assert_eq!((sine / t).to_f64(), number(2), "{row}");
        assert_eq!(sine.to_f64(), number(3), "{row}");
        assert_eq!(cosine.to_f64(), number(4), "{row}");
        // (C(t) - 1)/t^2 = -sign 2 (S(t/2)/t)^2, which does not cancel.
        let part = of(t * half).0 / t;
        assert_eq!(-sign * (two * part * part).to_f64(), number(5), "{row}");
    }
    assert!(looked_at >= 20, "{looked_at}");
}
