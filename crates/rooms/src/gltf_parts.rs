//! A `.gltf` whose buffers and pictures lie in other files of its room, as one `.glb` in memory.
//!
//! Each address is led to a file of the room by [`files::resolve`], or refused. What the description says besides stays
//! as it is: the reader of models looks at that.

use serde_json::{Map, Value, json};

use crate::bounds::{MOST_MODEL_BYTES, MOST_TEXTURE_BYTES};
use crate::files;

/// How many files a model may have beside its own.
const MOST_PARTS: usize = 32;
const MAGIC: u32 = 0x4654_6C67;
const JSON: u32 = 0x4E4F_534A;
const BIN: u32 = 0x004E_4942;

/// Puts a model's parts together. `name` is the model's file, `read` reads another file of the room.
///
/// # Errors
/// What is wrong with the description or an address, to follow the model's name.
pub(crate) fn gather(
    name: &str,
    description: &[u8],
    read: &mut dyn FnMut(&str) -> Result<Vec<u8>, String>,
) -> Result<Vec<u8>, String> {
    let mut root: Value = serde_json::from_slice(description)
        .map_err(|error| format!("its description is damaged ({error})"))?;
    let root_object = root
        .as_object_mut()
        .ok_or("its description is no description")?;
    let mut parts = Parts {
        name,
        read,
        data: Vec::new(),
        count: 0,
    };
    let offsets = parts.buffers(root_object)?;
    shift_views(root_object, &offsets)?;
    parts.pictures(root_object)?;
    if !parts.data.is_empty() {
        root_object.insert(
            "buffers".to_owned(),
            json!([{ "byteLength": parts.data.len() }]),
        );
    }
    glb(&root, &parts.data)
}

struct Parts<'a> {
    name: &'a str,
    read: &'a mut dyn FnMut(&str) -> Result<Vec<u8>, String>,
    data: Vec<u8>,
    count: usize,
}

impl Parts<'_> {
    /// Appends the file that an address means; where it begins, and how long it is.
    fn append(&mut self, address: &str) -> Result<(usize, usize), String> {
        self.count += 1;
        if self.count > MOST_PARTS {
            return Err(format!("it names more than {MOST_PARTS} files"));
        }
        if address.starts_with("data:") {
            return Err(
                "it has data in its text; save it as .glb, or with its data in a .bin file"
                    .to_owned(),
            );
        }
        let said = crate::check::shown(address);
        let file = files::resolve(self.name, address)
            .map_err(|reason| format!("its address {said} {reason}"))?;
        let bytes = (self.read)(&file)?;
        while !self.data.len().is_multiple_of(4) {
            self.data.push(0);
        }
        let begins = self.data.len();
        self.data.extend_from_slice(&bytes);
        if self.data.len() as u64 > MOST_MODEL_BYTES + MOST_TEXTURE_BYTES {
            return Err("its files have too many bytes together".to_owned());
        }
        Ok((begins, bytes.len()))
    }

    /// Appends every buffer; where each begins.
    fn buffers(&mut self, root: &Map<String, Value>) -> Result<Vec<usize>, String> {
        let mut offsets = Vec::new();
        for buffer in list(root.get("buffers")) {
            let address = buffer.get("uri").and_then(Value::as_str);
            let address = address.ok_or("it has a buffer without an address")?;
            let wanted = buffer
                .get("byteLength")
                .and_then(Value::as_u64)
                .unwrap_or(u64::MAX);
            let (begins, length) = self.append(address)?;
            if (length as u64) < wanted {
                return Err(format!(
                    "the file {} is shorter than it says",
                    crate::check::shown(address)
                ));
            }
            offsets.push(begins);
        }
        Ok(offsets)
    }

    /// Appends every picture that has an address, with a view of it in place of that.
    fn pictures(&mut self, root: &mut Map<String, Value>) -> Result<(), String> {
        let Some(mut pictures) = root.remove("images") else {
            return Ok(());
        };
        let mut views = match root.remove("bufferViews") {
            Some(Value::Array(views)) => views,
            _ => Vec::new(),
        };
        for picture in pictures.as_array_mut().into_iter().flatten() {
            let Some(address) = picture
                .get("uri")
                .and_then(Value::as_str)
                .map(str::to_owned)
            else {
                continue;
            };
            let (begins, length) = self.append(&address)?;
            let is_png = self.data[begins..].starts_with(b"\x89PNG");
            let kind = if is_png { "image/png" } else { "image/jpeg" };
            *picture = json!({ "bufferView": views.len(), "mimeType": kind });
            views.push(json!({ "buffer": 0, "byteOffset": begins, "byteLength": length }));
        }
        root.insert("images".to_owned(), pictures);
        if !views.is_empty() {
            root.insert("bufferViews".to_owned(), Value::Array(views));
        }
        Ok(())
    }
}

fn list(value: Option<&Value>) -> &[Value] {
    value.and_then(Value::as_array).map_or(&[], Vec::as_slice)
}

/// Leads every view of a buffer to where that begins in the one there is now.
fn shift_views(root: &mut Map<String, Value>, offsets: &[usize]) -> Result<(), String> {
    let views = root.get_mut("bufferViews").and_then(Value::as_array_mut);
    for view in views.into_iter().flatten().filter_map(Value::as_object_mut) {
        let buffer = view
            .get("buffer")
            .and_then(Value::as_u64)
            .and_then(|it| usize::try_from(it).ok());
        let begins = buffer
            .and_then(|it| offsets.get(it))
            .ok_or("it refers to a buffer that it does not have")?;
        let offset = view.get("byteOffset").and_then(Value::as_u64).unwrap_or(0);
        let shifted = offset
            .checked_add(*begins as u64)
            .ok_or("it refers to bytes that it does not have")?;
        view.insert("buffer".to_owned(), json!(0));
        view.insert("byteOffset".to_owned(), json!(shifted));
    }
    Ok(())
}

/// The container: glTF 2.0, chapter 4.
fn glb(root: &Value, data: &[u8]) -> Result<Vec<u8>, String> {
    let mut text = serde_json::to_vec(root).map_err(|error| error.to_string())?;
    while !text.len().is_multiple_of(4) {
        text.push(b' ');
    }
    let padding = data.len().next_multiple_of(4) - data.len();
    let data_bytes = if data.is_empty() {
        0
    } else {
        8 + data.len() + padding
    };
    let mut out = Vec::with_capacity(20 + text.len() + data_bytes);
    for number in [
        MAGIC,
        2,
        (20 + text.len() + data_bytes) as u32,
        text.len() as u32,
        JSON,
    ] {
        out.extend(number.to_le_bytes());
    }
    out.extend(text);
    if !data.is_empty() {
        for number in [(data.len() + padding) as u32, BIN] {
            out.extend(number.to_le_bytes());
        }
        out.extend_from_slice(data);
        out.extend(std::iter::repeat_n(0, padding));
    }
    Ok(out)
}
