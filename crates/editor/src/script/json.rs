//! Numbers in JSON: only finite ones are read, and each is written in its shortest form.

pub(crate) use formats::shortest;
use serde::de::{Error, Unexpected, Visitor};
use serde::{Deserialize, Deserializer, Serialize, Serializer};
use std::fmt;

/// A number as JSON; null if it is not finite, as JSON has no such numbers.
pub(crate) fn number(value: f32) -> serde_json::Value {
    serde_json::Number::from_f64(shortest(value)).map_or(serde_json::Value::Null, serde_json::Value::Number)
}

/// A position or direction as a JSON array.
pub(crate) fn vector(value: [f32; 3]) -> serde_json::Value {
    value.map(number).to_vec().into()
}

/// A number that is finite as an `f32` too.
#[derive(Clone, Copy)]
struct Finite(f32);

impl<'de> Deserialize<'de> for Finite {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(FiniteVisitor)
    }
}

struct FiniteVisitor;

impl Visitor<'_> for FiniteVisitor {
    type Value = Finite;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a finite number of at most 3.4e38")
    }

    fn visit_f64<E: Error>(self, value: f64) -> Result<Finite, E> {
        let narrow = value as f32;
        if narrow.is_finite() {
            Ok(Finite(narrow))
        } else {
            Err(E::invalid_value(Unexpected::Float(value), &self))
        }
    }

    fn visit_i64<E: Error>(self, value: i64) -> Result<Finite, E> {
        self.visit_f64(value as f64)
    }

    fn visit_u64<E: Error>(self, value: u64) -> Result<Finite, E> {
        self.visit_f64(value as f64)
    }

    /// JavaScript gives numbers that JSON can't express by their names.
    fn visit_str<E: Error>(self, value: &str) -> Result<Finite, E> {
        match value {
            "NaN" | "Infinity" | "-Infinity" => Err(E::custom(format!("{value} is not a finite number"))),
            _ => Err(E::invalid_type(Unexpected::Str(value), &self)),
        }
    }
}

impl Serialize for Finite {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_f64(shortest(self.0))
    }
}

/// `serde(with)` for a `u32` that counts something.
pub(crate) mod whole {
    use super::*;

    pub fn serialize<S: Serializer>(value: &u32, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_u32(*value)
    }

    pub fn deserialize<'de, D: Deserializer<'de>>(deserializer: D) -> Result<u32, D::Error> {
        let value = serde_json::Value::deserialize(deserializer)?;
        let Some(whole) = value.as_u64() else {
            return Err(D::Error::custom(format!("{value} is not a whole number of 0 or more")));
        };
        u32::try_from(whole)
            .map_err(|_| D::Error::custom(format!("{whole} is too large; it may be {} at most", u32::MAX)))
    }
}

/// `serde(with)` for an `i32` that shifts something by whole steps.
pub(crate) mod shift {
    use super::*;

    pub fn serialize<S: Serializer>(value: &i32, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_i32(*value)
    }

    pub fn deserialize<'de, D: Deserializer<'de>>(deserializer: D) -> Result<i32, D::Error> {
        let value = serde_json::Value::deserialize(deserializer)?;
        let whole = value.as_i64().and_then(|whole| i32::try_from(whole).ok());
        whole.ok_or_else(|| D::Error::custom(format!("{value} is not a whole number of that size")))
    }
}

/// `serde(with)` for an `Option<u32>` that counts something.
pub(crate) mod whole_option {
    use super::*;

    pub fn serialize<S: Serializer>(value: &Option<u32>, serializer: S) -> Result<S::Ok, S::Error> {
        value.serialize(serializer)
    }

    pub fn deserialize<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Option<u32>, D::Error> {
        whole::deserialize(deserializer).map(Some)
    }
}

/// `serde(with)` for an `f32`.
pub(crate) mod finite {
    use super::*;

    pub fn serialize<S: Serializer>(value: &f32, serializer: S) -> Result<S::Ok, S::Error> {
        Finite(*value).serialize(serializer)
    }

    pub fn deserialize<'de, D: Deserializer<'de>>(deserializer: D) -> Result<f32, D::Error> {
        Ok(Finite::deserialize(deserializer)?.0)
    }
}

/// `serde(with)` for an `Option<f32>`.
pub(crate) mod finite_option {
    use super::*;

    pub fn serialize<S: Serializer>(value: &Option<f32>, serializer: S) -> Result<S::Ok, S::Error> {
        value.map(Finite).serialize(serializer)
    }

    pub fn deserialize<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Option<f32>, D::Error> {
        Ok(Some(Finite::deserialize(deserializer)?.0))
    }
}

/// `serde(with)` for an `[f32; 3]`.
pub(crate) mod finite3 {
    use super::*;

    pub fn serialize<S: Serializer>(value: &[f32; 3], serializer: S) -> Result<S::Ok, S::Error> {
        value.map(Finite).serialize(serializer)
    }

    pub fn deserialize<'de, D: Deserializer<'de>>(deserializer: D) -> Result<[f32; 3], D::Error> {
        Ok(<[Finite; 3]>::deserialize(deserializer)?.map(|n| n.0))
    }
}

/// `serde(with)` for an `Option<[f32; 3]>`.
pub(crate) mod finite3_option {
    use super::*;

    pub fn serialize<S: Serializer>(value: &Option<[f32; 3]>, serializer: S) -> Result<S::Ok, S::Error> {
        value.map(|v| v.map(Finite)).serialize(serializer)
    }

    pub fn deserialize<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Option<[f32; 3]>, D::Error> {
        Ok(Some(finite3::deserialize(deserializer)?))
    }
}

/// `serde(with)` for an `Option<[[f32; 3]; 2]>`.
pub(crate) mod finite3_pair_option {
    use super::*;

    pub fn serialize<S: Serializer>(value: &Option<[[f32; 3]; 2]>, serializer: S) -> Result<S::Ok, S::Error> {
        value.map(|pair| pair.map(|v| v.map(Finite))).serialize(serializer)
    }

    pub fn deserialize<'de, D: Deserializer<'de>>(
        deserializer: D,
    ) -> Result<Option<[[f32; 3]; 2]>, D::Error> {
        Ok(Some(<[[Finite; 3]; 2]>::deserialize(deserializer)?.map(|v| v.map(|n| n.0))))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn numbers_print_as_people_write_them() {
        assert_eq!(number(0.1).to_string(), "0.1");
        assert_eq!(number(1.0).to_string(), "1.0");
        assert_eq!(number(-2.5e-9).to_string(), "-2.5e-9");
        assert_eq!(number(f32::NAN).to_string(), "null");
    }

    proptest! {
        #[test]
        fn numbers_come_back_to_the_bit(bits in any::<u32>()) {
            let value = f32::from_bits(bits);
            prop_assume!(value.is_finite());
            let text = number(value).to_string();
            let back: Finite = serde_json::from_str(&text).expect("a number");
            prop_assert_eq!(back.0.to_bits(), bits, "{}", text);
        }
    }
}
