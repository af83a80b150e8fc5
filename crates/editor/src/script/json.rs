//! Numbers in JSON: each is written in its shortest form.

pub(crate) use formats::shortest;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

/// A number as JSON; null if it is not finite, as JSON has no such numbers.
pub(crate) fn number(value: f32) -> serde_json::Value {
    serde_json::Number::from_f64(shortest(value)).map_or(serde_json::Value::Null, serde_json::Value::Number)
}

/// A position or direction as a JSON array.
pub(crate) fn vector(value: [f32; 3]) -> serde_json::Value {
    value.map(number).to_vec().into()
}

/// A number that is written in its shortest form.
#[derive(Clone, Copy)]
struct Finite(f32);

impl<'de> Deserialize<'de> for Finite {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        Ok(Self(f64::deserialize(deserializer)? as f32))
    }
}

impl Serialize for Finite {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_f64(shortest(self.0))
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
