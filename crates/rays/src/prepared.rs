//! Which shaders pictures are drawn with, so that they can be compiled ahead, on any thread, and those that are wanted first.

use wgpu::Device;

use crate::error::RaysError;
use crate::kinds::Kinds;
use crate::loaded::Loaded;
use crate::options::{Options, View};
use crate::packed::Rule;
use crate::raster::{Way, way};
use crate::rastered::sight;
use crate::rays::{Rays, accepted};
use crate::scene::{Eye, RayScene};

/// A shader that pictures are drawn with. It is compiled once, for all scenes that ask for it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Shader(Pass);

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Pass {
    /// Rays from the eye on.
    Rays(Kinds),
    /// Rays from where a raster has ended; whether that sees all.
    Rastered(Kinds, bool),
}

impl Rays {
    /// The shaders without which a picture cannot be drawn as these options say, those that are compiled already among them.
    pub fn shaders(
        &self,
        (scene, loaded): (&RayScene, &Loaded),
        eye: &Eye,
        options: Options,
    ) -> Vec<Shader> {
        let sight = sight(scene, loaded, eye, options);
        let by_rays = rules(options.view).iter().map(|rule| {
            let kinds = loaded.kinds(*rule).with_outlines(sight.outlines);
            Shader(Pass::Rays(kinds))
        });
        let by_rays: Vec<_> = by_rays.collect();
        match way(&sight) {
            way if self.begins_by_raster(loaded, way, options) => {
                vec![Shader(Pass::Rastered(loaded.kinds(way.rule()), false))]
            }
            _ => by_rays,
        }
    }

    /// All shaders that pictures of a scene are drawn with, whoever looks at it however.
    pub fn all_shaders(&self, loaded: &Loaded) -> Vec<Shader> {
        let rastered = |rule, sees_all| Pass::Rastered(loaded.kinds(rule), sees_all);
        let of_rule = |rule| {
            let kinds = loaded.kinds(rule);
            [kinds, kinds.with_outlines(true)].map(Pass::Rays)
        };
        let most = of_rule(Rule::Exact)
            .into_iter()
            .chain([rastered(Rule::Exact, false), rastered(Rule::Exact, true)]);
        let others = of_rule(Rule::Plain)
            .into_iter()
            .chain(of_rule(Rule::Thesis));
        let flat = [false, true].map(|sees_all| rastered(Rule::Plain, sees_all));
        most.chain(others).chain(flat).map(Shader).collect()
    }

    /// Whether a shader is there.
    pub fn is_compiled(&self, Shader(pass): Shader) -> bool {
        match pass {
            Pass::Rays(kinds) => self.has_pipeline(kinds),
            Pass::Rastered(kinds, sees_all) => self.raster.has_rays(kinds, sees_all),
        }
    }

    /// Whether all of them are.
    pub fn are_compiled(&self, shaders: &[Shader]) -> bool {
        shaders.iter().all(|it| self.is_compiled(*it))
    }

    /// Compiles a shader, which takes up to seconds.
    ///
    /// # Errors
    /// When the adapter refuses it.
    pub fn compile(&self, device: &Device, Shader(pass): Shader) -> Result<(), RaysError> {
        accepted(device, || match pass {
            Pass::Rays(kinds) => {
                self.pipeline(device, kinds);
            }
            Pass::Rastered(kinds, sees_all) => {
                self.rastered(device, kinds, sees_all);
            }
        })
    }

    /// Compiles all that pictures of a scene are drawn with, so that none waits for it.
    ///
    /// # Errors
    /// When the adapter refuses one.
    pub fn prepare(&self, device: &Device, loaded: &Loaded) -> Result<(), RaysError> {
        let all = self.all_shaders(loaded).into_iter();
        all.into_iter().try_for_each(|it| self.compile(device, it))
    }

    /// Whether a raster is to begin a picture that is drawn that way.
    pub(crate) fn begins_by_raster(&self, loaded: &Loaded, way: Way, options: Options) -> bool {
        let kinds = loaded.kinds(way.rule());
        let is_missing = || self.has_pipeline(kinds) && !self.raster.has_rays(kinds, false);
        options.raster && way != Way::Rays && !(options.as_compiled && is_missing())
    }
}

/// By which rules a picture is drawn.
fn rules(view: View) -> &'static [Rule] {
    match view {
        View::Exact => &[Rule::Exact],
        View::Thesis => &[Rule::Thesis],
        View::Plain => &[Rule::Plain],
        View::Split => &[Rule::Thesis, Rule::Exact],
    }
}
