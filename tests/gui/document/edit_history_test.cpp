#include "gui/document/edit_history.hpp"

#include <gtest/gtest.h>
#include <string>

namespace gaspard {
namespace {

constexpr RunId ring{1}, bell{2};

RunEntry named(RunId run, const std::string& name) { return {run, name, false}; }

Edit renaming(RunId run, const std::string& before, const std::string& after,
              const std::string& key = "name") {
    return {.key = key, .before = {named(run, before)}, .after = {named(run, after)}};
}

RunValues titled(RunId run, const std::string& title) {
    RunValues values;
    values.run = run;
    values.scenario.title = title;
    return values;
}

Edit changing(RunId run, const std::string& before, const std::string& after) {
    return {
        .key = "values", .before = {titled(run, before)}, .after = {titled(run, after)}, .settled = false};
}

std::string name_in(const std::vector<EditPart>& parts) { return std::get<RunEntry>(parts.front()).name; }
std::string title_in(const std::vector<EditPart>& parts) {
    return std::get<RunValues>(parts.front()).scenario.title;
}

TEST(EditHistory, StepsBackAndForward) {
    EditHistory history;
    EXPECT_FALSE(history.can_undo());
    history.record(renaming(ring, "a", "b", "first"));
    history.record(renaming(ring, "b", "c", "second"));
    EXPECT_EQ(history.undo_label(), "rename to c");
    EXPECT_EQ(name_in(history.step_back().before), "b");
    EXPECT_EQ(history.redo_label(), "rename to c");
    EXPECT_EQ(name_in(history.step_back().before), "a");
    EXPECT_FALSE(history.can_undo());
    EXPECT_EQ(name_in(history.step_forward().after), "b");
    EXPECT_EQ(name_in(history.step_forward().after), "c");
    EXPECT_FALSE(history.can_redo());
}

TEST(EditHistory, MergesEditsOfOneGestureAndKey) {
    EditHistory history;
    for (const auto& [before, after] : {std::pair{"a", "b"}, {"b", "c"}, {"c", "d"}})
        history.record(renaming(ring, before, after));
    EXPECT_EQ(history.undo_count(), 1U);
    history.end_gesture();
    history.record(renaming(ring, "d", "e"));
    EXPECT_EQ(history.undo_count(), 2U) << "the next gesture";
    history.record(renaming(ring, "e", "f", "other"));
    EXPECT_EQ(history.undo_count(), 3U) << "another key";
    history.step_back();
    EXPECT_EQ(name_in(history.step_back().before), "d");
    EXPECT_EQ(name_in(history.step_back().before), "a") << "the whole gesture";
    history.step_forward();
    history.record(renaming(ring, "d", "g"));
    EXPECT_EQ(history.undo_count(), 2U) << "an edit that was redone is complete";
}

TEST(EditHistory, AGestureThatEndsWhereItBeganIsNoEdit) {
    EditHistory history;
    history.record(renaming(ring, "x", "a"));
    history.end_gesture();
    history.record(renaming(ring, "a", "b"));
    history.record(renaming(ring, "b", "a"));
    EXPECT_EQ(history.undo_count(), 1U);
    history.record(renaming(ring, "a", "c")); // the gesture goes on
    EXPECT_EQ(history.undo_count(), 2U) << "the earlier gesture is left as it was";
    EXPECT_EQ(name_in(history.step_back().before), "a");
    EXPECT_EQ(name_in(history.step_back().before), "x");
}

TEST(EditHistory, ANewEditClearsTheOnesToRedo) {
    EditHistory history;
    history.record(renaming(ring, "a", "b"));
    history.step_back();
    history.record(renaming(ring, "a", "c"));
    EXPECT_FALSE(history.can_redo());
    EXPECT_EQ(name_in(history.step_back().after), "c");
}

TEST(EditHistory, DropsTheOldest) {
    EditHistory history;
    const std::size_t more = EditHistory::limit + 5;
    for (std::size_t i = 0; i < more; ++i)
        history.record(renaming(ring, std::to_string(i), std::to_string(i + 1), std::to_string(i)));
    EXPECT_EQ(history.undo_count(), EditHistory::limit);
    std::string oldest;
    while (history.can_undo()) oldest = name_in(history.step_back().before);
    EXPECT_EQ(oldest, "5");
}

TEST(EditHistory, RefusedEditsAreWithdrawn) {
    EditHistory history;
    history.record(changing(ring, "good", "bad"));
    history.end_gesture();
    history.record(renaming(bell, "a", "b"));
    history.record(changing(ring, "bad", "worse"));
    history.withdraw(titled(ring, "good"));
    EXPECT_EQ(history.undo_count(), 1U) << "the edit of another run stays";
    EXPECT_EQ(name_in(history.step_back().before), "a");
}

TEST(EditHistory, AGestureWhoseStartWasRefusedIsNotMergedWithTheOneBefore) {
    EditHistory history;
    history.record(changing(ring, "a", "b"));
    history.settle(ring);
    history.end_gesture();
    history.record(changing(ring, "b", "refused"));
    history.withdraw(titled(ring, "b"));
    history.record(changing(ring, "b", "c")); // the same drag goes on
    EXPECT_EQ(history.undo_count(), 2U);
    EXPECT_EQ(title_in(history.step_back().before), "b");
    EXPECT_EQ(title_in(history.step_back().before), "a");
}

TEST(EditHistory, AnEditIsCutBackToTheLastAcceptedValues) {
    EditHistory history;
    history.record(changing(ring, "start", "accepted"));
    history.record(changing(ring, "accepted", "refused")); // of the same gesture
    history.withdraw(titled(ring, "accepted"));
    ASSERT_EQ(history.undo_count(), 1U);
    const Edit& edit = history.step_back();
    EXPECT_EQ(title_in(edit.before), "start");
    EXPECT_EQ(title_in(edit.after), "accepted");
}

TEST(EditHistory, AcceptedEditsAreNotWithdrawn) {
    EditHistory history;
    history.record(changing(ring, "a", "b"));
    history.end_gesture();
    history.settle(ring);
    history.record(changing(ring, "b", "refused"));
    history.withdraw(titled(ring, "b"));
    ASSERT_EQ(history.undo_count(), 1U);
    EXPECT_EQ(title_in(history.step_back().after), "b");
}

TEST(EditHistory, ForgetsARun) {
    EditHistory history;
    history.record(renaming(ring, "a", "b", "first"));
    history.record(renaming(bell, "c", "d", "second"));
    history.record(renaming(ring, "b", "e", "third"));
    history.step_back();
    EXPECT_TRUE(history.mentions(ring));
    history.forget(ring);
    EXPECT_FALSE(history.mentions(ring));
    EXPECT_FALSE(history.can_redo());
    EXPECT_EQ(history.undo_count(), 1U);
    EXPECT_EQ(history.undo_label(), "rename to d");
}

} // namespace
} // namespace gaspard
