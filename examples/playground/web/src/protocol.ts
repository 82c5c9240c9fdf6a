// SPDX-License-Identifier: MIT

/**
 * What the page asks the planning engine (engine/engine.cpp), and what the engine answers. Requests
 * and replies are JSON; a request may bring bytes along. Lengths are in metres, angles in radians,
 * times in the units that names say. Cells (x, y) count from that corner of a
 * map where x and y are least.
 */

export type Point = [number, number];

/** An obstacle as the scene files of the library have it. */
export type Obstacle = { polygon: Point[]; holes?: Point[][] } | { center: Point; radius: number };

/** Polygons and discs. This is the format of the library's own scene files (io/workspace_json.hpp). */
export interface WorkspaceScene {
  name?: string;
  /** x0, y0, x1, y1 */
  bounds: [number, number, number, number];
  safety_radius: number;
  obstacles: Obstacle[];
  start?: Point;
  goals?: Point[];
  /** Lattice spacing; the engine chooses 1/200 of the longer side without it. */
  resolution?: number;
}

/** A grid map. Its cells are the bytes of the request or reply: row by row, that of the least y
 * first; 1 is free. */
export interface CellScene {
  name?: string;
  width: number;
  height: number;
  /** Side of a cell. */
  resolution: number;
  /** The corner of cell (0, 0) with the least x and y, in the frame of the grid. */
  origin: Point;
  /** Whether y grows downwards in pictures, as the rows of MovingAI's files do. */
  y_down?: boolean;
  /** Where the map itself lies, if its rows are not along the axes of its frame (ROS maps). Points
   * of requests and of samples are in the frame of the grid; `result` is in that of the map. */
  map?: { origin: Point; yaw: number };
  safety_radius: number;
  start?: Point;
  goals?: Point[];
}

export type Movement = 'no_cut' | 'no_squeeze' | 'allow' | 'four_connected';

/** Replaces the scene. Later `plan` requests are on it. */
export type SceneRequest =
  | { do: 'scene'; workspace: WorkspaceScene; movement?: Movement }
  | { do: 'scene'; cells: CellScene; movement?: Movement };
export interface SceneReply {
  /** The lattice spacing or side of a cell that is used. */
  resolution: number;
  width: number;
  height: number;
}

/** A vehicle that is not a point or disc that turns on the spot. For searches that plan headings. */
export interface VehicleChoice {
  min_turning_radius: number;
  reverse: boolean;
  /** A rectangle around the vehicle, covered by discs; without it the vehicle is a point. The
   * reference point is the middle of the rear axle. */
  car?: { length: number; width: number; wheelbase: number };
}

/** Limits on the motion along a curve (motion/speed_limits.hpp). */
export interface SpeedLimits {
  max_speed: number;
  max_acceleration: number;
  max_deceleration: number;
  max_lateral_acceleration: number;
  /** none: accelerations may jump */
  max_jerk?: number;
}

export interface PlanRequest {
  do: 'plan';
  /** "astar", or with options "rrt_star:max_iterations=5000,goal_bias=0.1". */
  search: string;
  /** The same; stages are joined by a plus: "shortcut+bezier:trim=0.5". */
  smoother: string;
  start: Point;
  goal: Point;
  /** Headings, for searches that plan them. */
  start_heading?: number;
  goal_heading?: number;
  vehicle?: VehicleChoice;
  seed?: number;
  /** [s] */
  time_limit?: number;
  /** How many nodes the search may expand; 3000000 without it. */
  max_expansions?: number;
  /** Whether to look for the length of the shortest path there is (for one second at most). */
  optimum?: boolean;
  /** Asks for a speed profile. */
  speed?: SpeedLimits;
  /** Asks for the events of the search, at most so many. */
  events?: number;
  /** Asks for a spline along the route that nobody checked. */
  unchecked?: boolean;
  /** About how many samples the curve gets; 300 without it. */
  samples?: number;
}

/** A curve, drawn: the same index of every list is one sample. */
export interface Samples {
  x: number[];
  y: number[];
  /** Where the robot faces: in reverse not the direction in which it moves. */
  heading: number[];
  /** Arc length from the start. */
  s: number[];
  /** 1/m, left turns positive; null where it is infinite. */
  curvature: (number | null)[];
  /** Distance of the reference point to the nearest obstacle; null without obstacles. */
  clearance: (number | null)[];
  /** Of a vehicle: 1 forwards, -1 in reverse. */
  gear?: number[];
  /** The first sample of every piece. */
  pieces: number[];
}

export type ProofStatus = 'proved' | 'violated' | 'undecided';
export interface Certificate {
  status: ProofStatus;
  /** The smallest clearance along the whole curve lies between them. */
  lower: number | null;
  upper: number | null;
  /** Where it is smallest, or where the curve is not safe. */
  point: Point;
  piece: number;
  parameter: number;
}

export interface Metrics {
  length: number;
  turning_points: number;
  turning_angle: number;
  interior_angle_sum: number;
  max_joint_deflection: number;
  max_curvature: number | null;
  max_curvature_jump: number;
  min_clearance: number | null;
  mean_clearance?: number;
}

export interface PlanStatistics {
  expanded: number;
  generated: number;
  search_us: number;
  smooth_us: number;
  certify_us: number;
  seed: number;
}

/** A curve of which a proof was tried. */
export interface JudgedCurve {
  curve: Samples;
  /** In the frame of the map, as that of the result. */
  certificate: Certificate;
}

/** One entry of a result file (docs/command-line.md), as the engine makes it. */
export interface Result {
  /** "success", or the code of the failure, such as "unreachable". */
  status: string;
  search: string;
  smoother: string;
  fell_back: boolean;
  start: Point;
  goal: Point;
  safety_radius: number;
  options: unknown;
  stats: PlanStatistics;
  // of a plan
  found_by?: string;
  metrics?: Metrics;
  certificate?: Certificate;
  optimum?: { length: number; ratio: number };
  // of a failure
  detail?: string;
  clearance?: number;
  obstacle?: number;
  nearest_safe_point?: Point;
}

/** What a robot does at one time on its way. */
export interface SpeedSamples {
  duration: number;
  /** The same index is one moment, at equal steps of time. */
  time: number[];
  s: number[];
  speed: number[];
  acceleration: number[];
}

/** The events of a search, in order. */
export interface SearchEvents {
  /** One letter an event: e expanded, g generated (x, y); i interval, r rectangle from start, I and
   * R the same from the goal, t edge of a tree (x0, y0, x1, y1). */
  kinds: string;
  /** The coordinates of all events, one after the other. */
  coordinates: number[];
  /** Events beyond the number asked for, which are left out. */
  left_out: number;
  /** Side of a cell, to draw expanded cells. */
  cell_size: number;
}

export interface PlanReply {
  result: Result;
  /** The route and the curve of a plan. */
  route?: Samples;
  curve?: Samples;
  /** A smoothed curve that is not safe, so that the plan kept its route: what was wrong with it. */
  refused?: JudgedCurve;
  /** The cubic B-spline whose control points are the corners of the route, and whether it is safe. */
  unchecked?: JudgedCurve;
  /** Why the smoother gave no curve at all, so that the plan kept its route. */
  smoother_failure?: string;
  /** The profile, or why there is none. */
  speed?: SpeedSamples | { detail: string };
  events?: SearchEvents;
  /** The discs that cover the vehicle, around its reference point. */
  footprint?: { offset: Point; radius: number }[];
  /** Wall-clock time of the whole request in the engine. */
  us: number;
}

/** What there is to choose from. */
export interface OptionDescription {
  name: string;
  /** "number", "whole number", "true|false", "a|b|c"; with "|none" if it need not be given. */
  type: string;
  unit: string;
  default_value: string;
  sentence: string;
}
export interface AlgorithmDescription {
  name: string;
  sentence: string;
  options: OptionDescription[];
  /** Whether it works on polygons and discs, and on grid maps. */
  on_workspace: boolean;
  on_cells: boolean;
  /** Whether it plans, or keeps, headings. Only these go together; `none` goes with all. */
  for_vehicles: boolean;
}
export interface CatalogueRequest {
  do: 'catalogue';
}
export interface CatalogueReply {
  version: string;
  searches: AlgorithmDescription[];
  smoothers: AlgorithmDescription[];
}

/** A map that is built in: "array", "complex", "maze", "rrt_scene_1" or "rrt_scene_2". */
export interface BuiltinRequest {
  do: 'builtin';
  name: string;
}

/** A node of a YAML document, as io/text/yaml_node.hpp has it. Lines count from 1. */
export interface YamlNode {
  kind: 'nothing' | 'scalar' | 'list' | 'map';
  line: number;
  text?: string;
  /** Items; of a map its keys and values by turns. Indices of the list of nodes. */
  children?: number[];
}

/** Reads a file. Its bytes come with the request. The kind follows from the end of the name: .json,
 * .geojson, .wkt, .csv (with the name of the column), .map. */
export interface OpenRequest {
  do: 'open';
  name: string;
  /** The column of a .csv file that holds WKT. */
  wkt_column?: string;
  /** What swamp and water of a .map file are. */
  terrain?: 'refused' | 'blocked' | 'free';
}
/** Reads a ROS map: the nodes of its YAML file, the root first, and as bytes its image. */
export interface OpenRosRequest {
  do: 'open_ros';
  name: string;
  yaml: YamlNode[];
  unknown: 'blocked' | 'free';
}
/** Reads the scenarios of a MovingAI map: starts and goals in the middle of cells, and the length of
 * the shortest path of steps. */
export interface OpenScenariosRequest {
  do: 'open_scenarios';
  name: string;
}
export interface ScenariosReply {
  scenarios: { map: string; start: Point; goal: Point; optimum: number }[];
}
/** The cells of a grid map are the bytes of the reply. What the file does not say is missing:
 * bounds are made to fit, the safety radius is 0. */
export type OpenReply = { warnings: string[] } & (
  { workspace: WorkspaceScene } | { cells: CellScene }
);

/** The picture of a plan, drawn by the library. */
export interface SvgRequest {
  do: 'svg';
  plans: PlanRequest[];
}
export interface SvgReply {
  svg: string;
}

export type Request =
  | CatalogueRequest
  | BuiltinRequest
  | SceneRequest
  | PlanRequest
  | OpenRequest
  | OpenRosRequest
  | OpenScenariosRequest
  | SvgRequest;

/** Bad input: a wrong file, an unknown name, an invalid option. The text says what to do. */
export interface ErrorReply {
  error: string;
}
