//! The texts are valid, and keep within what every adapter has.

use antipode_rays::{PICTURE, PROBE, RASTER, RASTERED};
use naga::valid::{Capabilities, ValidationFlags, Validator};

#[test]
fn every_text_is_valid_wgsl() {
    for files in [&PICTURE[..], &PROBE[..], &RASTERED[..], &[RASTER][..]] {
        let source = files.join("\n");
        let module = naga::front::wgsl::parse_str(&source)
            .map_err(|e| e.emit_to_string(&source))
            .unwrap_or_else(|words| panic!("{words}"));
        Validator::new(ValidationFlags::all(), Capabilities::empty())
            .validate(&module)
            .unwrap_or_else(|error| panic!("{error:?}"));
        let storages = module
            .global_variables
            .iter()
            .filter(|(_, variable)| matches!(variable.space, naga::AddressSpace::Storage { .. }));
        assert!(
            storages.count() <= 8,
            "more storage buffers than every adapter has"
        );
    }
}
