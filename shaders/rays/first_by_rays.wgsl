// Where light of the eye is met first and where it goes on: by rays throughout. Follows picture.wgsl; first_by_raster.wgsl is the
// other one.

fn next_seen(path: Path, longest: f32, bounce: u32, pixel: vec2<u32>) -> Ended {
    return trace(path, longest, false, bounce == 0u, frame.pixel_rad);
}
