//! Numbers out of accessors, with every length and offset of the file checked before it is used.

use gltf::json::accessor::{Accessor, ComponentType, IndexComponentType, Type, sparse};
use gltf::json::validation::Checked::{self, Valid};
use gltf::json::{Index, Root, buffer};

use crate::error::Error;

/// No accessor has more rows than this.
const MOST_ROWS: usize = 1 << 22;

/// The file's description beside its data.
#[derive(Clone, Copy)]
pub struct Source<'a> {
    /// The description, validated.
    pub root: &'a Root,
    /// The binary chunk.
    pub data: &'a [u8],
}

/// How an accessor's rows are to be understood.
struct Layout {
    component: ComponentType,
    width: usize,
    normalised: bool,
}

/// Components of an accessor as stored, row after row.
pub struct Rows {
    /// The components; integers that are not normalised keep their value.
    pub values: Vec<f64>,
    /// Components in a row.
    pub width: usize,
    /// What the file stores.
    pub component: ComponentType,
    /// Whether integers stand for 0 to 1 or -1 to 1.
    pub normalised: bool,
}

impl<'a> Source<'a> {
    /// The rows of an accessor; `what` names it in errors.
    pub fn rows(self, index: Index<Accessor>, what: &'static str) -> Result<Rows, Error> {
        let accessor = self
            .root
            .accessors
            .get(index.value())
            .ok_or(Error::OutOfRange(what))?;
        let layout = layout(accessor, what)?;
        let count = usize::try_from(accessor.count.0).map_err(|_| Error::TooMany(what))?;
        if count > MOST_ROWS {
            return Err(Error::TooMany(what));
        }
        let mut values = match accessor.buffer_view {
            Some(view) => self.read(
                view,
                accessor.byte_offset.map_or(0, |o| o.0),
                count,
                &layout,
                what,
            )?,
            None => vec![0.0; count * layout.width],
        };
        if let Some(sparse) = &accessor.sparse {
            self.put_sparse(sparse, &layout, &mut values, what)?;
        }
        if values.iter().any(|v| !v.is_finite()) {
            return Err(Error::Absurd(what));
        }
        Ok(Rows {
            values,
            width: layout.width,
            component: layout.component,
            normalised: layout.normalised,
        })
    }

    /// Rows of `N` floats. Normalised integers become their fractions; others must be floats.
    pub fn floats<const N: usize>(
        self,
        index: Index<Accessor>,
        what: &'static str,
    ) -> Result<Vec<[f32; N]>, Error> {
        let rows = self.rows(index, what)?;
        if rows.width != N || (rows.component != ComponentType::F32 && !rows.normalised) {
            return Err(Error::Format(what));
        }
        let row = |row: &[f64]| std::array::from_fn(|i| row[i] as f32);
        Ok(rows.values.chunks_exact(N).map(row).collect())
    }

    /// The bytes of a buffer view.
    pub fn view(
        self,
        index: Index<buffer::View>,
        what: &'static str,
    ) -> Result<(&'a [u8], Option<usize>), Error> {
        let view = self
            .root
            .buffer_views
            .get(index.value())
            .ok_or(Error::OutOfRange(what))?;
        let buffer = self
            .root
            .buffers
            .get(view.buffer.value())
            .ok_or(Error::OutOfRange(what))?;
        // The first buffer without an address is the binary chunk; there is no other place for data in a .glb.
        if buffer.uri.is_some() || view.buffer.value() != 0 {
            return Err(Error::External("data"));
        }
        let start = usize::try_from(view.byte_offset.map_or(0, |o| o.0))
            .map_err(|_| Error::OutOfRange(what))?;
        let length = usize::try_from(view.byte_length.0).map_err(|_| Error::OutOfRange(what))?;
        let end = start.checked_add(length).ok_or(Error::OutOfRange(what))?;
        let bytes = self.data.get(start..end).ok_or(Error::OutOfRange(what))?;
        Ok((bytes, view.byte_stride.map(|stride| stride.0)))
    }

    fn read(
        self,
        view: Index<buffer::View>,
        offset: u64,
        count: usize,
        layout: &Layout,
        what: &'static str,
    ) -> Result<Vec<f64>, Error> {
        let (bytes, stride) = self.view(view, what)?;
        let size = layout.component.size();
        let row = size * layout.width;
        let stride = stride.unwrap_or(row);
        let offset = usize::try_from(offset).map_err(|_| Error::OutOfRange(what))?;
        let bytes = bytes.get(offset..).ok_or(Error::OutOfRange(what))?;
        let needed = count
            .saturating_sub(1)
            .checked_mul(stride)
            .and_then(|n| n.checked_add(row));
        if stride < row || needed.is_none_or(|n| count > 0 && n > bytes.len()) {
            return Err(Error::OutOfRange(what));
        }
        let mut out = Vec::with_capacity(count * layout.width);
        for k in 0..count {
            for cell in bytes[k * stride..k * stride + row].chunks_exact(size) {
                out.push(number(cell, layout));
            }
        }
        Ok(out)
    }

    fn put_sparse(
        self,
        sparse: &sparse::Sparse,
        layout: &Layout,
        values: &mut [f64],
        what: &'static str,
    ) -> Result<(), Error> {
        let count = usize::try_from(sparse.count.0).map_err(|_| Error::TooMany(what))?;
        if count > MOST_ROWS {
            return Err(Error::TooMany(what));
        }
        let Valid(IndexComponentType(
            component @ (ComponentType::U8 | ComponentType::U16 | ComponentType::U32),
        )) = sparse.indices.component_type
        else {
            return Err(Error::Format(what));
        };
        let places = Layout {
            component,
            width: 1,
            normalised: false,
        };
        let rows = self.read(
            sparse.indices.buffer_view,
            sparse.indices.byte_offset.0,
            count,
            &places,
            what,
        )?;
        let new = self.read(
            sparse.values.buffer_view,
            sparse.values.byte_offset.0,
            count,
            layout,
            what,
        )?;
        for (row, from) in rows.iter().zip(new.chunks_exact(layout.width)) {
            let start = *row as usize * layout.width;
            let to = values
                .get_mut(start..start + layout.width)
                .ok_or(Error::OutOfRange(what))?;
            to.copy_from_slice(from);
        }
        Ok(())
    }
}

fn layout(accessor: &Accessor, what: &'static str) -> Result<Layout, Error> {
    let (Valid(component), Valid(kind)) = (accessor.component_type, accessor.type_) else {
        return Err(Error::Format(what));
    };
    let width = match kind {
        Type::Scalar => 1,
        Type::Vec2 => 2,
        Type::Vec3 => 3,
        Type::Vec4 => 4,
        Type::Mat4 => 16,
        // Their columns are padded, and nothing that is read here has them.
        Type::Mat2 | Type::Mat3 => return Err(Error::Format(what)),
    };
    Ok(Layout {
        component: component.0,
        width,
        normalised: accessor.normalized,
    })
}

/// One component from its little-endian bytes; fractions as glTF 2.0, 3.6.2.2 has them.
fn number(cell: &[u8], layout: &Layout) -> f64 {
    let (value, most) = match (layout.component, cell) {
        (ComponentType::I8, &[a]) => (f64::from(a as i8), 127.0),
        (ComponentType::U8, &[a]) => (f64::from(a), 255.0),
        (ComponentType::I16, &[a, b]) => (f64::from(i16::from_le_bytes([a, b])), 32767.0),
        (ComponentType::U16, &[a, b]) => (f64::from(u16::from_le_bytes([a, b])), 65535.0),
        (ComponentType::U32, &[a, b, c, d]) => return f64::from(u32::from_le_bytes([a, b, c, d])),
        (ComponentType::F32, &[a, b, c, d]) => return f64::from(f32::from_le_bytes([a, b, c, d])),
        _ => return f64::NAN,
    };
    if layout.normalised {
        (value / most).max(-1.0)
    } else {
        value
    }
}

/// What validation has let through.
pub fn valid<T: Copy>(checked: Checked<T>, what: &'static str) -> Result<T, Error> {
    match checked {
        Valid(value) => Ok(value),
        Checked::Invalid => Err(Error::Format(what)),
    }
}
