//! A value of TOML or JSON: one data model, two notations.

use super::Value;
use super::write::quoted_key;
use crate::units::{cut, told};
use serde::de::{Deserialize, Deserializer, MapAccess, SeqAccess, Visitor};
use std::fmt;

/// A value of TOML or JSON.
pub(super) enum Node {
    Number(f64),
    Text(String),
    Flag(bool),
    List(Vec<Node>),
    Map(Vec<(String, Node)>),
    /// A date of TOML, as it is spelled, or null.
    Other(String),
}

impl Node {
    /// Whether the node is a table, with keys of its own.
    pub(super) fn is_map(&self) -> bool {
        matches!(self, Node::Map(_))
    }
}

impl From<toml::Value> for Node {
    fn from(value: toml::Value) -> Node {
        match value {
            toml::Value::Float(number) => Node::Number(number),
            toml::Value::Integer(number) => Node::Number(number as f64),
            toml::Value::String(text) => Node::Text(text),
            toml::Value::Boolean(flag) => Node::Flag(flag),
            toml::Value::Array(list) => Node::List(list.into_iter().map(Node::from).collect()),
            toml::Value::Table(map) => {
                Node::Map(map.into_iter().map(|(k, v)| (k, v.into())).collect())
            }
            toml::Value::Datetime(date) => Node::Other(date.to_string()),
        }
    }
}

/// JSON with every key, repeated keys included.
impl<'de> Deserialize<'de> for Node {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Node, D::Error> {
        deserializer.deserialize_any(NodeVisitor)
    }
}

struct NodeVisitor;

impl<'de> Visitor<'de> for NodeVisitor {
    type Value = Node;

    fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str("a value")
    }

    fn visit_bool<E>(self, flag: bool) -> Result<Node, E> {
        Ok(Node::Flag(flag))
    }

    fn visit_i64<E>(self, number: i64) -> Result<Node, E> {
        Ok(Node::Number(number as f64))
    }

    fn visit_u64<E>(self, number: u64) -> Result<Node, E> {
        Ok(Node::Number(number as f64))
    }

    fn visit_f64<E>(self, number: f64) -> Result<Node, E> {
        Ok(Node::Number(number))
    }

    fn visit_str<E>(self, text: &str) -> Result<Node, E> {
        Ok(Node::Text(text.to_string()))
    }

    fn visit_string<E>(self, text: String) -> Result<Node, E> {
        Ok(Node::Text(text))
    }

    fn visit_unit<E>(self) -> Result<Node, E> {
        Ok(Node::Other("null".to_string()))
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut items: A) -> Result<Node, A::Error> {
        let mut list = Vec::new();
        while let Some(item) = items.next_element()? {
            list.push(item);
        }
        Ok(Node::List(list))
    }

    fn visit_map<A: MapAccess<'de>>(self, mut entries: A) -> Result<Node, A::Error> {
        let mut map = Vec::new();
        while let Some(entry) = entries.next_entry()? {
            map.push(entry);
        }
        Ok(Node::Map(map))
    }
}

/// Rows of numbers typed as text in brackets; `None` for any other text.
pub(super) fn rows_of_text(text: &str) -> Option<Value> {
    match node_of(text)? {
        list @ Node::List(_) => {
            Some(rows(&list).map_or(Value::Other(text.to_string()), Value::Rows))
        }
        _ => None,
    }
}

/// Description, for a message, of a value that no input takes, from its spelling in TOML; of rows, the row at fault.
pub(super) fn described(spelling: &str, rows_expected: bool) -> String {
    match node_of(spelling) {
        Some(list @ Node::List(_)) if rows_expected => {
            rows(&list).err().unwrap_or_else(|| describe(&list))
        }
        Some(node) => describe(&node),
        None => cut(spelling),
    }
}

fn node_of(spelling: &str) -> Option<Node> {
    let mut table: toml::Table = toml::from_str(&format!("value = {spelling}")).ok()?;
    let node = Node::from(table.remove("value")?);
    table.is_empty().then_some(node)
}

/// Numbers of the rows, or a description of the row at fault.
pub(super) fn rows(node: &Node) -> Result<Vec<Vec<f64>>, String> {
    let Node::List(list) = node else {
        return Err(describe(node));
    };
    let number = |node: &Node| match node {
        Node::Number(number) => Ok(*number),
        other => Err(describe(other)),
    };
    // Numbers without brackets of their own are one row.
    if !list.is_empty() && list.iter().all(|node| matches!(node, Node::Number(_))) {
        return Ok(vec![
            list.iter().filter_map(|node| number(node).ok()).collect(),
        ]);
    }
    let row = |(i, row): (usize, &Node)| match row {
        Node::List(cells) => {
            let cells: Result<Vec<f64>, String> = cells.iter().map(number).collect();
            cells.map_err(|cell| format!("row {} with {cell}", i + 1))
        }
        _ => Err(format!("row {} that is not a list of numbers", i + 1)),
    };
    list.iter().enumerate().map(row).collect()
}

pub(super) fn describe(node: &Node) -> String {
    match node {
        Node::Number(number) => told(*number),
        Node::Text(text) => format!("\"{}\"", cut(text)),
        Node::Flag(flag) => flag.to_string(),
        Node::List(_) => "a list".to_string(),
        Node::Map(_) => "an empty table".to_string(),
        Node::Other(what) if what == "null" => what.clone(),
        Node::Other(_) => "a date".to_string(),
    }
}

/// A value as TOML spells it; null, which TOML has not, by its name.
pub(super) fn spelled(node: &Node) -> String {
    let listed = |parts: Vec<String>| parts.join(", ");
    match node {
        Node::Number(number) => toml::Value::Float(*number).to_string(),
        Node::Text(text) => toml::Value::String(text.clone()).to_string(),
        Node::Flag(flag) => flag.to_string(),
        Node::List(list) => format!("[{}]", listed(list.iter().map(spelled).collect())),
        Node::Map(map) => {
            let entry =
                |(key, node): &(String, Node)| format!("{} = {}", quoted_key(key), spelled(node));
            format!("{{{}}}", listed(map.iter().map(entry).collect()))
        }
        Node::Other(what) => what.clone(),
    }
}
