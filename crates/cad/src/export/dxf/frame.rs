//! Required content of a release 2000 drawing around its entities: header, tables, blocks, objects.

/// Generator of unique handles.
pub struct Handles {
    next: u32,
}

impl Default for Handles {
    fn default() -> Self {
        // lower handles are used by the fixed records
        Self { next: 0x100 }
    }
}

impl Handles {
    /// A handle not used before.
    pub fn next(&mut self) -> String {
        self.next += 1;
        format!("{:X}", self.next)
    }
}

/// Layer of a drawing.
pub struct Layer {
    name: String,
    color: u8,
}

impl Layer {
    /// A layer with a DXF color index.
    pub fn new(name: &str, color: u8) -> Self {
        Self {
            name: name.to_owned(),
            color,
        }
    }
}

/// The complete drawing.
pub fn drawing(layers: &[Layer], entities: &str, mut handles: Handles) -> String {
    let tables = tables(layers, &mut handles);
    let seed = handles.next();
    [
        &section(
            "HEADER",
            &format!(
                "9\n$ACADVER\n1\nAC1015\n9\n$DWGCODEPAGE\n3\nANSI_1252\n9\n$INSUNITS\n70\n4\n\
                 9\n$MEASUREMENT\n70\n1\n9\n$HANDSEED\n5\n{seed}\n"
            ),
        ),
        &section("TABLES", &tables),
        &section("BLOCKS", BLOCKS),
        &section("ENTITIES", entities),
        &section("OBJECTS", OBJECTS),
        "0\nEOF\n",
    ]
    .concat()
}

fn section(name: &str, content: &str) -> String {
    format!("0\nSECTION\n2\n{name}\n{content}0\nENDSEC\n")
}

/// A table: name, handle, class of its records, records with their names.
fn table([name, handle]: [&str; 2], records: &[String]) -> String {
    let more = if name == "DIMSTYLE" {
        "100\nAcDbDimStyleTable\n"
    } else {
        ""
    };
    format!(
        "0\nTABLE\n2\n{name}\n5\n{handle}\n330\n0\n100\nAcDbSymbolTable\n70\n{}\n{more}{}0\nENDTAB\n",
        records.len(),
        records.concat()
    )
}

/// A record: type, class, handle, owner and name, followed by its other groups.
fn record([kind, class, handle, owner, name]: [&str; 5], rest: &str) -> String {
    let code = if kind == "DIMSTYLE" { 105 } else { 5 };
    format!(
        "0\n{kind}\n{code}\n{handle}\n330\n{owner}\n100\nAcDbSymbolTableRecord\n100\n{class}\n2\n{name}\n{rest}"
    )
}

fn tables(layers: &[Layer], handles: &mut Handles) -> String {
    let line = |handle: &str, name: &str, text: &str| {
        record(
            ["LTYPE", "AcDbLinetypeTableRecord", handle, "5", name],
            &format!("70\n0\n3\n{text}\n72\n65\n73\n0\n40\n0.0\n"),
        )
    };
    let layer = |handle: &str, name: &str, color: u8| {
        record(
            ["LAYER", "AcDbLayerTableRecord", handle, "2", name],
            &format!("70\n0\n62\n{color}\n6\nContinuous\n370\n-3\n390\nF\n"),
        )
    };
    let mut own = vec![layer("10", "0", 7)];
    own.extend(
        layers
            .iter()
            .map(|l| layer(&handles.next(), &l.name, l.color)),
    );
    let view = "70\n0\n10\n0.0\n20\n0.0\n11\n1.0\n21\n1.0\n12\n500.0\n22\n250.0\n13\n0.0\n23\n0.0\n14\n10.0\n24\n10.0\n\
                15\n10.0\n25\n10.0\n16\n0.0\n26\n0.0\n36\n1.0\n17\n0.0\n27\n0.0\n37\n0.0\n40\n1200.0\n41\n1.5\n42\n50.0\n\
                43\n0.0\n44\n0.0\n50\n0.0\n51\n0.0\n71\n0\n72\n100\n73\n1\n74\n3\n75\n0\n76\n0\n77\n0\n78\n0\n";
    let block = |handle: &str, name: &str| {
        record(
            ["BLOCK_RECORD", "AcDbBlockTableRecord", handle, "1", name],
            "340\n0\n",
        )
    };
    [
        table(
            ["VPORT", "8"],
            &[record(
                ["VPORT", "AcDbViewportTableRecord", "29", "8", "*Active"],
                view,
            )],
        ),
        table(
            ["LTYPE", "5"],
            &[
                line("14", "ByBlock", ""),
                line("15", "ByLayer", ""),
                line("16", "Continuous", "Solid line"),
            ],
        ),
        table(["LAYER", "2"], &own),
        table(
            ["STYLE", "3"],
            &[record(
                ["STYLE", "AcDbTextStyleTableRecord", "11", "3", "Standard"],
                "70\n0\n40\n0.0\n41\n1.0\n50\n0.0\n71\n0\n42\n2.5\n3\ntxt\n4\n\n",
            )],
        ),
        table(["VIEW", "6"], &[]),
        table(["UCS", "7"], &[]),
        table(
            ["APPID", "9"],
            &[record(
                ["APPID", "AcDbRegAppTableRecord", "12", "9", "ACAD"],
                "70\n0\n",
            )],
        ),
        table(
            ["DIMSTYLE", "A"],
            &[record(
                ["DIMSTYLE", "AcDbDimStyleTableRecord", "27", "A", "Standard"],
                "70\n0\n",
            )],
        ),
        table(
            ["BLOCK_RECORD", "1"],
            &[block("1F", "*Model_Space"), block("1B", "*Paper_Space")],
        ),
    ]
    .concat()
}

const BLOCKS: &str = "\
0\nBLOCK\n5\n20\n330\n1F\n100\nAcDbEntity\n8\n0\n100\nAcDbBlockBegin\n2\n*Model_Space\n70\n0\n10\n0.0\n20\n0.0\n30\n0.0\n3\n*Model_Space\n1\n\n\
0\nENDBLK\n5\n21\n330\n1F\n100\nAcDbEntity\n8\n0\n100\nAcDbBlockEnd\n\
0\nBLOCK\n5\n1C\n330\n1B\n100\nAcDbEntity\n67\n1\n8\n0\n100\nAcDbBlockBegin\n2\n*Paper_Space\n70\n0\n10\n0.0\n20\n0.0\n30\n0.0\n3\n*Paper_Space\n1\n\n\
0\nENDBLK\n5\n1D\n330\n1B\n100\nAcDbEntity\n67\n1\n8\n0\n100\nAcDbBlockEnd\n";

const OBJECTS: &str = "\
0\nDICTIONARY\n5\nC\n330\n0\n100\nAcDbDictionary\n281\n1\n3\nACAD_GROUP\n350\nD\n3\nACAD_PLOTSTYLENAME\n350\nE\n\
0\nDICTIONARY\n5\nD\n330\nC\n100\nAcDbDictionary\n281\n1\n\
0\nACDBDICTIONARYWDFLT\n5\nE\n330\nC\n100\nAcDbDictionary\n281\n1\n3\nNormal\n350\nF\n100\nAcDbDictionaryWithDefault\n340\nF\n\
0\nACDBPLACEHOLDER\n5\nF\n330\nE\n";
