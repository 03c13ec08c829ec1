//! What tests read from the locale files.
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::PathBuf;

use antipode_language::Language;
use fluent_syntax::ast::{
    Entry, Expression, InlineExpression, Pattern, PatternElement, Resource, VariantKey,
};
use fluent_syntax::parser;

/// Messages by their keys.
pub type Messages = BTreeMap<String, Message>;

/// What a message refers to.
#[derive(Debug, Default)]
pub struct Message {
    /// The values it is given.
    pub arguments: BTreeSet<String>,
    /// Other messages that it takes in.
    pub messages: BTreeSet<String>,
    /// The cases of each of its selectors.
    pub plurals: Vec<BTreeSet<String>>,
}

/// The workspace's root.
pub fn root() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// Name and contents of the files of a language.
fn sources(language: Language) -> Vec<(String, String)> {
    let dir = root().join("assets/locales").join(language.id());
    let paths = dir.read_dir().unwrap().map(|entry| entry.unwrap().path());
    paths
        .map(|path| {
            (
                path.display().to_string(),
                fs::read_to_string(path).unwrap(),
            )
        })
        .collect()
}

/// The messages of a language.
pub fn messages(language: Language) -> Messages {
    let sources = sources(language).into_iter();
    sources
        .flat_map(|(_, source)| messages_of(&source))
        .collect()
}

/// What cannot be read, and keys that are there twice.
pub fn faults(language: Language) -> Vec<String> {
    let mut known = BTreeSet::new();
    let mut faults = Vec::new();
    for (path, source) in sources(language) {
        if let Err((_, errors)) = parser::parse(source.as_str()) {
            faults.extend(errors.iter().map(|error| format!("{path}: {error}")));
        }
        for key in messages_of(&source).into_keys() {
            if !known.insert(key.clone()) {
                faults.push(format!("{path}: {key} is there twice"));
            }
        }
    }
    faults
}

/// The messages in a source text; what cannot be read is left out.
pub fn messages_of(source: &str) -> Messages {
    let Resource { body } = parser::parse(source).unwrap_or_else(|(rest, _)| rest);
    let mut all = Messages::new();
    for entry in body {
        if let Entry::Message(message) = entry {
            let mut found = Message::default();
            if let Some(pattern) = &message.value {
                gather(pattern, &mut found);
            }
            all.insert(message.id.name.to_owned(), found);
        }
    }
    all
}

fn gather(pattern: &Pattern<&str>, into: &mut Message) {
    for element in &pattern.elements {
        if let PatternElement::Placeable { expression } = element {
            gather_expression(expression, into);
        }
    }
}

fn gather_expression(expression: &Expression<&str>, into: &mut Message) {
    match expression {
        Expression::Inline(inline) => gather_inline(inline, into),
        Expression::Select { selector, variants } => {
            gather_inline(selector, into);
            let name = |key: &VariantKey<&str>| match key {
                VariantKey::Identifier { name } => (*name).to_owned(),
                VariantKey::NumberLiteral { value } => (*value).to_owned(),
            };
            into.plurals
                .push(variants.iter().map(|variant| name(&variant.key)).collect());
            for variant in variants {
                gather(&variant.value, into);
            }
        }
    }
}

fn gather_inline(inline: &InlineExpression<&str>, into: &mut Message) {
    match inline {
        InlineExpression::VariableReference { id } => {
            into.arguments.insert(id.name.to_owned());
        }
        InlineExpression::MessageReference { id, .. } => {
            into.messages.insert(id.name.to_owned());
        }
        InlineExpression::Placeable { expression } => gather_expression(expression, into),
        InlineExpression::FunctionReference { arguments, .. } => {
            for argument in &arguments.positional {
                gather_inline(argument, into);
            }
        }
        _ => {}
    }
}
