-- The session file of Fodscope: one SQLite database holds one inspection.
--
-- `acts` is the record. Every other table but `blobs` repeats what the acts' payloads say, in columns that a query can
-- use; `fodscope-cli verify` checks that the two agree. Nothing is ever updated or deleted: a correction is a later act.
--
-- Units stand in the column names: _m metres, _rad radians, _px pixels of the photo as received, _utc ISO 8601 in UTC.
-- Frames too: _reference is the frame of the reference map (z up), _map the frame of the map under inspection.

PRAGMA application_id = 0x464F4453; -- "FODS"
PRAGMA user_version = 2;            -- raised with every change of the schema or of a payload

CREATE TABLE acts (
    sequence         INTEGER PRIMARY KEY,   -- 1, 2, 3, … without a gap
    kind             TEXT NOT NULL,         -- header, reference, map, parameters, detection, route, plan, visit,
                                            -- photo, label set, decision, report
    payload          TEXT NOT NULL,         -- JSON; names each blob it rests on by its SHA-256
    author           TEXT NOT NULL,         -- the person who acted, or "not recorded"
    time_utc         TEXT NOT NULL,         -- when the act was written
    software_version TEXT NOT NULL,         -- the Fodscope that wrote it
    previous_hash    TEXT NOT NULL,         -- hash of the act before; 64 zeros in the first
    hash             TEXT NOT NULL UNIQUE   -- SHA-256 over all the columns above, see storage/ActChain.h
) STRICT;

CREATE TRIGGER acts_are_never_changed BEFORE UPDATE ON acts
BEGIN SELECT RAISE(ABORT, 'acts are never changed'); END;
CREATE TRIGGER acts_are_never_deleted BEFORE DELETE ON acts
BEGIN SELECT RAISE(ABORT, 'acts are never deleted'); END;

-- Photos as received and clouds. The layout of the clouds is described in storage/CloudBlobs.h.
CREATE TABLE blobs (
    sha256 TEXT PRIMARY KEY,   -- of `bytes`, 64 lower-case hexadecimal digits
    format TEXT NOT NULL,      -- image/jpeg, image/png, fodscope.reference/1, fodscope.field/1, fodscope.voxels/1,
                               -- fodscope.coverage/1, fodscope.grid/1
    bytes  BLOB NOT NULL
) STRICT;

-- The candidates of each detection, most suspicious first. The latest detection counts.
CREATE TABLE candidates (
    act                    INTEGER NOT NULL REFERENCES acts(sequence),
    position               INTEGER NOT NULL,   -- 0 is the most suspicious
    id                     TEXT NOT NULL,      -- "C-001"
    points                 INTEGER NOT NULL,   -- voxels
    centroid_x_reference_m REAL,
    centroid_y_reference_m REAL,
    centroid_z_reference_m REAL,
    centroid_x_map_m       REAL,
    centroid_y_map_m       REAL,
    centroid_z_map_m       REAL,
    length_m               REAL,               -- in the plane of the floor, length >= width
    width_m                REAL,
    height_m               REAL,               -- vertical extent
    height_above_floor_m   REAL,               -- of the centroid
    discrepancy_max        REAL,               -- metres for Euclidean, else unitless
    discrepancy_mean       REAL,
    PRIMARY KEY (act, position)
) STRICT;

-- Waypoints of each plan in visit order, "W-01", and poses of each inspection route, "R-01", which is driven before the
-- map is there. The latest plan and the latest route count.
CREATE TABLE waypoints (
    act         INTEGER NOT NULL REFERENCES acts(sequence),
    position    INTEGER NOT NULL,
    id          TEXT NOT NULL,       -- "W-01"
    candidates  TEXT NOT NULL,       -- JSON list of candidate ids
    x_map_m     REAL,                -- null: no pose was found, `status` tells why
    y_map_m     REAL,
    yaw_map_rad REAL,
    cost        REAL,                -- summed along the line of sight
    status      TEXT NOT NULL,
    drive_m     REAL,                -- from the waypoint before, along the cost map
    PRIMARY KEY (act, position)
) STRICT;

-- States of the visits as they came; the last row of a waypoint counts, its time is that of the act.
--
-- state: draft → sent → accepted → driving → arrived → photo → done, or failed; skipped. Back in draft it is tried again.
-- reason, empty when all is well:
--   tried again, then failed: not acknowledged, rejected, aborted, goal forgotten, not departed, not arrived, arrived
--     elsewhere; photo missing, photo late, photo corrupt, photo blank, photo repeated, photo of another place, photo of
--     another time;
--   in draft until a person looks: link lost, preempted, stopped at robot, stopped by operator, not localised, clock off,
--     interrupted;
--   skipped: skipped by operator, no pose; in files of the first version a sentence.
CREATE TABLE visits (
    act         INTEGER NOT NULL REFERENCES acts(sequence),
    position    INTEGER NOT NULL,
    waypoint_id TEXT NOT NULL,
    state       TEXT NOT NULL,
    goal_id     TEXT NOT NULL,
    reason      TEXT NOT NULL,
    tries       INTEGER NOT NULL,            -- goals sent
    detail      TEXT NOT NULL DEFAULT '',    -- what the robot said, or what was measured
    photo_tries INTEGER NOT NULL DEFAULT 0,  -- photos asked for with the latest goal
    PRIMARY KEY (act, position)
) STRICT;

CREATE TABLE photos (
    act         INTEGER PRIMARY KEY REFERENCES acts(sequence),
    id          TEXT NOT NULL UNIQUE,   -- "P-001"
    waypoint_id TEXT NOT NULL,
    candidates  TEXT NOT NULL,          -- JSON list of candidate ids
    taken_utc   TEXT NOT NULL,
    media_type  TEXT NOT NULL,
    width_px    INTEGER NOT NULL,
    height_px   INTEGER NOT NULL,
    fx_px       REAL,
    fy_px       REAL,
    cx_px       REAL,
    cy_px       REAL,
    T_map_from_camera TEXT NOT NULL,    -- JSON list of 16 numbers, row-major; optical frame: z forward, x right, y down
    sha256      TEXT NOT NULL REFERENCES blobs(sha256),
    request_id  TEXT NOT NULL DEFAULT ''    -- the request that it answers, "W-01/1/photo-1": goal and how manieth photo
) STRICT;

-- Decisions as they were made; the last one of each labeller on each photo counts.
CREATE TABLE decisions (
    act         INTEGER PRIMARY KEY REFERENCES acts(sequence),
    photo_id    TEXT NOT NULL REFERENCES photos(id),
    labeller    TEXT NOT NULL,
    decided_utc TEXT NOT NULL,
    takes_back  INTEGER NOT NULL,       -- 1: an undo; its labels are those that count again, none if it has none
    comment     TEXT NOT NULL
) STRICT;

CREATE TABLE decision_labels (
    act       INTEGER NOT NULL REFERENCES decisions(act),
    position  INTEGER NOT NULL,
    label     TEXT NOT NULL,
    left_px   REAL,                     -- null: no box was drawn
    top_px    REAL,
    width_px  REAL,
    height_px REAL,
    PRIMARY KEY (act, position)
) STRICT;
