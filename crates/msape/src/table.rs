//! Tables of answers: CSV, KML. (being written)
