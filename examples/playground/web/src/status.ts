// SPDX-License-Identifier: MIT

import type { App, Outcome } from './app.ts';
import { plannerName, type Planner } from './choices.ts';
import { duration, excess, metres, point, short } from './format.ts';
import type { PlanReply, Result } from './protocol.ts';

export type Tone = 'good' | 'warning' | 'bad' | 'busy';
export interface Status {
  tone: Tone;
  text: string;
}

export function planTime(result: Result): number {
  const { search_us, smooth_us, certify_us } = result.stats;
  return search_us + smooth_us + certify_us;
}

/** One word for the table. */
export function verdict(app: App, outcome: Outcome | undefined): { tone: Tone; word: string } {
  if (!outcome || !app.isFresh(outcome)) return { tone: 'busy', word: 'planning' };
  const { reply } = outcome;
  if (!reply) return { tone: 'bad', word: 'refused' };
  const { result } = reply;
  if (result.status !== 'success') return { tone: 'bad', word: result.status.replaceAll('_', ' ') };
  if (result.certificate?.status !== 'proved')
    return { tone: 'bad', word: result.certificate?.status ?? 'not proved' };
  return result.fell_back || reply.refused
    ? { tone: 'warning', word: 'proved, route kept' }
    : { tone: 'good', word: 'proved' };
}

/** The engine writes numbers with all their digits. */
function rounded(text: string): string {
  return text.replace(/-?\d+\.\d{4,}/g, (number) => short(Number(number)));
}

function failure(planner: Planner, result: Result): string {
  const reason = result.detail ?? result.status.replaceAll('_', ' ');
  return `No plan by ${plannerName(planner)}: ${rounded(reason)}.`;
}

function refusal(planner: Planner, reply: PlanReply): string {
  const smoother = planner.stages.map(({ name }) => name).join('+');
  if (!reply.refused)
    return `${smoother} gave no curve${reply.smoother_failure ? ` (${rounded(reply.smoother_failure)})` : ''}, so the plan keeps the route. `;
  const { certificate } = reply.refused;
  const clearance =
    certificate.upper === null ? '' : ` its clearance is ${metres(certificate.upper)},`;
  return `${smoother}'s curve was refused: at ${point(certificate.point)}${clearance || ' it is not safe,'} so the plan keeps the route. `;
}

/** What is wrong with the spline that nobody checked. */
function warning({ unchecked }: PlanReply): string {
  if (!unchecked) return '';
  const { certificate } = unchecked;
  if (certificate.status === 'proved') return ' The unchecked spline is safe here.';
  return ` The unchecked spline is not safe: at ${point(certificate.point)} its clearance is ${metres(certificate.upper)}.`;
}

/** The state of the active plan in words. */
export function describe(app: App): Status {
  const planner = app.activePlanner;
  const outcome = app.outcomes.get(app.active);
  if (!planner || !outcome || !app.isFresh(outcome)) return { tone: 'busy', text: 'Planning.' };
  const { reply, error } = outcome;
  if (!reply)
    return {
      tone: 'bad',
      text: `${plannerName(planner)}: ${error === 'cancelled' ? 'planning was cancelled; change something to plan again.' : (error ?? '')}`,
    };
  const { result } = reply;
  if (result.status !== 'success') return { tone: 'bad', text: failure(planner, result) };
  const { certificate, metrics, optimum } = result;
  const length = `The path of ${plannerName(planner)} is ${metres(metrics?.length)} long`;
  const ratio = optimum ? `, ${excess(optimum.ratio)} (${metres(optimum.length)})` : '';
  const time = `. Planned in ${duration(planTime(result))}.`;
  if (certificate?.status !== 'proved')
    return { tone: 'bad', text: `Not proved: ${length}${ratio}${time}` };
  const clearance =
    certificate.lower === null
      ? 'there is no obstacle'
      : `the clearance of the whole curve is at least ${metres(certificate.lower)}, smallest at ${point(certificate.point)}`;
  const fell = result.fell_back || reply.refused;
  return {
    tone: fell ? 'warning' : 'good',
    text: `${fell ? refusal(planner, reply) : ''}Proved: ${clearance}. ${length}${ratio}${time}${warning(reply)}`,
  };
}
