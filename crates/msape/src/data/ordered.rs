//! Shipped files as types. The fields of a struct are looked up in the order of its declaration, so that the program holds
//! no search among names for each type: that was a tenth of what a browser loads. Keys that a type does not have are passed
//! over; a test reads the same files as those of a user are read, which refuses them.

use serde::Deserializer;
use serde::de::value::{MapAccessDeserializer, MapDeserializer};
use serde::de::{DeserializeSeed, Error as _, IntoDeserializer, SeqAccess, Unexpected, Visitor};
use serde_json::{Error, Map, Value};
use std::slice::Iter;

/// The value of a key, or nothing where there is no such key.
#[derive(Clone, Copy)]
pub(super) struct Ordered<'v>(pub Option<&'v Value>);

impl<'v> Ordered<'v> {
    #[cold]
    fn not(self, expected: &str) -> Error {
        let found = match self.0 {
            None => return Error::custom("missing value"),
            Some(Value::Null) => Unexpected::Unit,
            Some(Value::Bool(flag)) => Unexpected::Bool(*flag),
            Some(Value::Number(number)) => Unexpected::Float(number.as_f64().unwrap_or(f64::NAN)),
            Some(Value::String(text)) => Unexpected::Str(text),
            Some(Value::Array(_)) => Unexpected::Seq,
            Some(Value::Object(_)) => Unexpected::Map,
        };
        Error::invalid_type(found, &expected)
    }

    fn number(self) -> Result<f64, Error> {
        let number = self.0.and_then(Value::as_f64);
        number.ok_or_else(|| self.not("a number"))
    }

    fn whole(self) -> Result<u64, Error> {
        let number = self.0.and_then(Value::as_u64);
        number.ok_or_else(|| self.not("a whole number"))
    }

    fn flag(self) -> Result<bool, Error> {
        let flag = self.0.and_then(Value::as_bool);
        flag.ok_or_else(|| self.not("true or false"))
    }

    fn text(self) -> Result<&'v str, Error> {
        let text = self.0.and_then(Value::as_str);
        text.ok_or_else(|| self.not("a text"))
    }

    fn list(self) -> Result<&'v [Value], Error> {
        let list = self.0.and_then(Value::as_array);
        list.map(Vec::as_slice).ok_or_else(|| self.not("a list"))
    }

    fn table(self) -> Result<&'v Map<String, Value>, Error> {
        let table = self.0.and_then(Value::as_object);
        table.ok_or_else(|| self.not("a table"))
    }

    fn entries(self) -> Result<impl Iterator<Item = (&'v str, Ordered<'v>)>, Error> {
        let entries = self.table()?.iter();
        Ok(entries.map(|(key, value)| (key.as_str(), Ordered(Some(value)))))
    }
}

impl<'v> IntoDeserializer<'v, Error> for Ordered<'v> {
    type Deserializer = Self;

    fn into_deserializer(self) -> Self {
        self
    }
}

/// Methods that take a value of one kind.
macro_rules! kinds {
    ($($method:ident $kind:ident $visit:ident)*) => {
        $(fn $method<V: Visitor<'v>>(self, visitor: V) -> Result<V::Value, Error> {
            visitor.$visit(self.$kind()?)
        })*
    };
}

impl<'v> Deserializer<'v> for Ordered<'v> {
    type Error = Error;

    kinds! {
        deserialize_bool flag visit_bool
        deserialize_f32 number visit_f64
        deserialize_f64 number visit_f64
        deserialize_u8 whole visit_u64
        deserialize_u16 whole visit_u64
        deserialize_u32 whole visit_u64
        deserialize_u64 whole visit_u64
        deserialize_char text visit_borrowed_str
        deserialize_identifier text visit_borrowed_str
        deserialize_str text visit_borrowed_str
        deserialize_string text visit_borrowed_str
    }

    fn deserialize_any<V: Visitor<'v>>(self, visitor: V) -> Result<V::Value, Error> {
        match self.0 {
            None | Some(Value::Null) => Err(self.not("a value")),
            Some(Value::Bool(flag)) => visitor.visit_bool(*flag),
            Some(Value::Number(number)) => match number.as_u64() {
                Some(whole) => visitor.visit_u64(whole),
                None => visitor.visit_f64(self.number()?),
            },
            Some(Value::String(text)) => visitor.visit_borrowed_str(text),
            Some(Value::Array(_)) => self.deserialize_seq(visitor),
            Some(Value::Object(_)) => self.deserialize_map(visitor),
        }
    }

    fn deserialize_ignored_any<V: Visitor<'v>>(self, visitor: V) -> Result<V::Value, Error> {
        visitor.visit_unit()
    }

    fn deserialize_option<V: Visitor<'v>>(self, visitor: V) -> Result<V::Value, Error> {
        match self.0 {
            None => visitor.visit_none(),
            Some(_) => visitor.visit_some(self),
        }
    }

    fn deserialize_newtype_struct<V: Visitor<'v>>(
        self,
        _: &'static str,
        visitor: V,
    ) -> Result<V::Value, Error> {
        visitor.visit_newtype_struct(self)
    }

    fn deserialize_seq<V: Visitor<'v>>(self, visitor: V) -> Result<V::Value, Error> {
        visitor.visit_seq(&mut Items(self.list()?.iter()))
    }

    fn deserialize_tuple<V: Visitor<'v>>(self, _: usize, visitor: V) -> Result<V::Value, Error> {
        let list = self.list()?;
        let mut items = Items(list.iter());
        let tuple = visitor.visit_seq(&mut items)?;
        match items.0.as_slice() {
            [] => Ok(tuple),
            _ => Err(Error::invalid_length(list.len(), &"fewer values")),
        }
    }

    fn deserialize_map<V: Visitor<'v>>(self, visitor: V) -> Result<V::Value, Error> {
        visitor.visit_map(MapDeserializer::new(self.entries()?))
    }

    fn deserialize_struct<V: Visitor<'v>>(
        self,
        _: &'static str,
        names: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, Error> {
        let (table, names) = (self.table()?, names.iter());
        visitor.visit_seq(Fields { table, names })
    }

    fn deserialize_enum<V: Visitor<'v>>(
        self,
        _: &'static str,
        _: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, Error> {
        match self.0 {
            Some(Value::String(name)) => visitor.visit_enum(name.as_str().into_deserializer()),
            _ => visitor.visit_enum(MapAccessDeserializer::new(MapDeserializer::new(
                self.entries()?,
            ))),
        }
    }

    serde::forward_to_deserialize_any! {
        <V: Visitor<'v>> bytes byte_buf i8 i16 i32 i64 i128 u128 unit unit_struct tuple_struct
    }
}

/// Values of a list.
struct Items<'v>(Iter<'v, Value>);

impl<'v> SeqAccess<'v> for &mut Items<'v> {
    type Error = Error;

    fn next_element_seed<T: DeserializeSeed<'v>>(
        &mut self,
        seed: T,
    ) -> Result<Option<T::Value>, Error> {
        let value = self.0.next();
        value
            .map(|value| seed.deserialize(Ordered(Some(value))))
            .transpose()
    }

    fn size_hint(&self) -> Option<usize> {
        Some(self.0.len())
    }
}

/// Values of a table by the names of fields.
struct Fields<'v> {
    table: &'v Map<String, Value>,
    names: Iter<'static, &'static str>,
}

impl<'v> SeqAccess<'v> for Fields<'v> {
    type Error = Error;

    fn next_element_seed<T: DeserializeSeed<'v>>(
        &mut self,
        seed: T,
    ) -> Result<Option<T::Value>, Error> {
        let value = self.names.next().and_then(|name| self.table.get(*name));
        match seed.deserialize(Ordered(value)) {
            // a field that may be absent takes its default, any other is a fault of the length
            Err(_) if value.is_none() => Ok(None),
            read => read.map(Some),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde::Deserialize;
    use serde_json::json;

    #[derive(Debug, PartialEq, Deserialize)]
    struct Whole {
        part: Part,
        list: Vec<(f64, u32)>,
        kind: Option<Kind>,
        #[serde(default)]
        text: String,
    }

    #[derive(Debug, PartialEq, Deserialize)]
    #[serde(tag = "form", rename_all = "kebab-case")]
    enum Part {
        Ball { radius_m: f64 },
        None,
    }

    #[derive(Debug, PartialEq, Deserialize)]
    #[serde(rename_all = "kebab-case")]
    enum Kind {
        Plain,
        Named(String),
    }

    fn read(value: Value) -> Result<Whole, String> {
        Whole::deserialize(Ordered(Some(&value))).map_err(|error| error.to_string())
    }

    #[test]
    fn a_struct_is_as_serde_json_reads_it_whatever_the_order_of_its_keys() {
        for value in [
            json!({"kind": "plain", "list": [[1, 2], [0.5, 3]], "part": {"form": "ball", "radius_m": 2}, "other": 1}),
            json!({"part": {"form": "none"}, "text": "x", "kind": {"named": "y"}, "list": []}),
            json!({"part": {"form": "none"}, "list": []}),
        ] {
            assert_eq!(
                read(value.clone()),
                Ok(serde_json::from_value(value).unwrap())
            );
        }
    }

    #[test]
    fn a_missing_key_and_a_value_of_another_kind_are_faults() {
        for value in [
            json!({"list": []}),
            json!({"part": {"form": "none"}, "list": [[1]]}),
            json!({"part": {"form": "none"}, "list": [[1, 2, 3]]}),
            json!({"part": {"form": "none"}, "list": [[1, -2]]}),
            json!({"part": {"form": "none"}, "list": 1}),
            json!({"part": {"form": "cube"}, "list": []}),
            json!({"part": {"form": "ball"}, "list": []}),
            json!({"part": {"form": "none"}, "list": [], "text": 1}),
            json!([]),
        ] {
            assert!(read(value.clone()).is_err(), "{value}");
        }
    }
}
