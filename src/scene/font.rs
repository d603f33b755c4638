//! Letters of 3 x 5 dots, for captions.
use super::picture::Picture;

/// Rows of a letter, top first, three bits each; small letters look like capitals.
fn rows(letter: char) -> u32 {
    match letter.to_ascii_lowercase() {
        '0' => 0o75557,
        '1' => 0o26227,
        '2' => 0o71747,
        '3' => 0o71317,
        '4' => 0o55711,
        '5' => 0o74717,
        '6' => 0o74757,
        '7' => 0o71222,
        '8' => 0o75757,
        '9' => 0o75717,
        'a' => 0o25755,
        'b' => 0o65656,
        'c' => 0o34443,
        'd' => 0o65556,
        'e' => 0o74647,
        'f' => 0o74644,
        'g' => 0o34553,
        'h' => 0o55755,
        'i' => 0o72227,
        'j' => 0o11152,
        'k' => 0o55655,
        'l' => 0o44447,
        'm' => 0o57755,
        'n' => 0o65555,
        'o' => 0o25552,
        'p' => 0o65644,
        'q' => 0o25563,
        'r' => 0o65655,
        's' => 0o34216,
        't' => 0o72222,
        'u' => 0o55557,
        'v' => 0o55552,
        'w' => 0o55775,
        'x' => 0o55255,
        'y' => 0o55222,
        'z' => 0o71247,
        '-' => 0o00700,
        ':' => 0o02020,
        ',' => 0o00024,
        '.' => 0o00002,
        '/' => 0o11244,
        _ => 0,
    }
}

impl Picture {
    /// Writes `text` with its upper left corner at (x, y), each dot `zoom` pixels wide.
    pub(super) fn text(&mut self, x: usize, y: usize, zoom: usize, colour: [u8; 3], text: &str) {
        for (place, letter) in text.chars().enumerate() {
            let rows = rows(letter);
            for dot in (0..15).filter(|dot| rows >> (14 - dot) & 1 == 1) {
                let (left, top) = (x + (place * 4 + dot % 3) * zoom, y + dot / 3 * zoom);
                self.block(left, top, zoom, zoom, colour);
            }
        }
    }

    /// Fills a rectangle, as far as it lies in the picture.
    pub(super) fn block(&mut self, left: usize, top: usize, width: usize, height: usize, colour: [u8; 3]) {
        for y in top..top + height {
            for x in left..left + width {
                self.set(x, y, colour);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_word_has_ink_where_its_letters_are() {
        let mut picture = Picture::blank(20, 5);
        picture.text(0, 0, 1, [0; 3], "Hi 1");
        let ink = |x: usize, y: usize| picture.pixels[y * 20 + x] == [0; 3];
        let row = |y: usize| (0..15).map(|x| if ink(x, y) { '#' } else { '.' }).collect::<String>();
        assert_eq!(row(0), "#.#.###......#.");
        assert_eq!(row(2), "###..#.......#.");
    }
}
