//! What is wrong with a text that should be JSON.

use serde_json::error::Category;

/// Why a text is not JSON, as a clause in plain words: "it ends too early", "there is a mistake at line 2, column 7".
pub fn json_fault(error: &serde_json::Error) -> String {
    let place = format!("line {}, column {}", error.line(), error.column());
    match error.classify() {
        Category::Eof => {
            "it ends before it is complete (a bracket, a quote or a value is missing)".to_owned()
        }
        Category::Syntax | Category::Data | Category::Io => {
            format!("there is a mistake at {place} (check the quotes, commas and brackets there)")
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn faults_are_in_plain_words() {
        let fault = |text: &str| json_fault(&serde_json::from_str::<serde_json::Value>(text).unwrap_err());
        assert!(fault("{\"a\": [1, 2").starts_with("it ends before it is complete"));
        assert!(fault("").starts_with("it ends before it is complete"));
        assert!(fault("{op: 1}").starts_with("there is a mistake at line 1, column 2"));
        assert!(fault("[1,\n2 3]").starts_with("there is a mistake at line 2, column 3"));
    }
}
